#include "viewer/messages.h"

#include <algorithm>

namespace weft::viewer {

namespace {

constexpr std::chrono::seconds shown_done{6}, shown_trouble{12};
constexpr std::size_t most_shown = 4;

}  // namespace

void Messages::add(MessageKind kind, const std::string& text) {
    const Clock::time_point until =
        Clock::now() + (kind == MessageKind::done ? shown_done : shown_trouble);
    for (Message& message : present_) {
        if (message.text == text) {
            message.until = until;
            return;
        }
    }
    all_.push_back(text);
    present_.push_back({kind, text, until});
    if (present_.size() > most_shown) present_.erase(present_.begin());
}

const std::vector<Message>& Messages::present() {
    const Clock::time_point now = Clock::now();
    std::erase_if(present_, [now](const Message& message) { return message.until < now; });
    return present_;
}

void Messages::dismiss() {
    present_.clear();
}

}  // namespace weft::viewer
