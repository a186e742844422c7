#include "viewer/window.h"

#include "viewer/application.h"

namespace weft::viewer {

WindowReport run_window(const WindowRequest& request) {
    Application application(request);
    return application.run();
}

}  // namespace weft::viewer
