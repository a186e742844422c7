#include "io/mesh_file.h"

#include <assimp/cimport.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>
#include <sstream>
#include <utility>

#include "cloth/mesh_check.h"
#include "io/obj_check.h"
#include "io/ply_check.h"
#include "weft/error.h"

namespace weft {

namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 31;

std::string read_bytes(const std::filesystem::path& path) {
    std::error_code status;
    const bool regular = std::filesystem::is_regular_file(path, status);
    if (!regular && !status) throw file_error(path.string(), "cannot be read: not a file");
    const std::uintmax_t size = status ? 0 : std::filesystem::file_size(path, status);
    if (status)
        throw file_error(path.string(), fmt::format("cannot be read: {}", status.message()));
    if (size > largest_file)
        throw file_error(path.string(), fmt::format("a mesh file of {} bytes is too large: at most "
                                                    "{} are allowed",
                                                    size, largest_file));
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                               &std::fclose);
    if (!file)
        throw file_error(path.string(), fmt::format("cannot be read: {}", std::strerror(errno)));
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size())
        throw file_error(path.string(), "cannot be read: the file ended before its end");
    return bytes;
}

/// A polygon as a file has it.
struct PolygonCorner {
    std::uint32_t position = 0, uv = 0;
};

/// Adds a polygon of three or more corners; one of more than four is cut from its first corner.
void add_polygon(std::span<const PolygonCorner> corners, std::uint32_t number, Mesh& mesh) {
    const auto add = [&](std::initializer_list<std::size_t> picked) {
        Mesh::Face face;
        face.corners = 0;
        for (const std::size_t k : picked) {
            face.position[static_cast<std::size_t>(face.corners)] = corners[k].position;
            face.uv[static_cast<std::size_t>(face.corners++)] = corners[k].uv;
        }
        mesh.faces.push_back(face);
        mesh.source_faces.push_back(number);
    };
    if (corners.size() == 4) return add({0, 1, 2, 3});
    for (std::size_t k = 2; k < corners.size(); ++k) add({0, k - 1, k});
}

/// Where no polygon was cut, every face is its own.
void drop_plain_sources(std::uint32_t polygons, Mesh& mesh) {
    if (mesh.faces.size() == polygons) mesh.source_faces.clear();
}

/// What the OBJ library's calls add up to.
struct ObjReading {
    Mesh mesh;
    std::string file;
    std::uint32_t polygons = 0;
    bool every_corner_has_uv = true;

    /// From a number of the file, where -1 is the last one so far, to an index.
    std::uint32_t index_of(int number, std::size_t count, const char* what) const {
        if (number > 0) return static_cast<std::uint32_t>(number - 1);
        const auto back = static_cast<std::size_t>(-static_cast<std::int64_t>(number));
        if (back > count)
            throw file_error(file, fmt::format("face {} names {} {}, but {} stand before it",
                                               polygons + 1, what, number, count));
        return static_cast<std::uint32_t>(count - back);
    }

    void add_face(std::span<const tinyobj::index_t> indices) {
        std::vector<PolygonCorner> corners;
        for (const tinyobj::index_t& index : indices) {
            PolygonCorner corner;
            corner.position = index_of(index.vertex_index, mesh.positions.size(), "vertex");
            if (index.texcoord_index == 0)
                every_corner_has_uv = false;
            else
                corner.uv = index_of(index.texcoord_index, mesh.uvs.size(), "texture vertex");
            corners.push_back(corner);
        }
        add_polygon(corners, polygons++, mesh);
    }
};

tinyobj::callback_t obj_calls() {
    tinyobj::callback_t calls;
    calls.vertex_cb = [](void* reading, double x, double y, double z, double) {
        static_cast<ObjReading*>(reading)->mesh.positions.push_back({x, y, z});
    };
    calls.texcoord_cb = [](void* reading, double u, double v, double) {
        static_cast<ObjReading*>(reading)->mesh.uvs.push_back(
            {static_cast<float>(u), static_cast<float>(v)});
    };
    calls.index_cb = [](void* reading, tinyobj::index_t* indices, int count) {
        static_cast<ObjReading*>(reading)->add_face({indices, static_cast<std::size_t>(count)});
    };
    return calls;
}

Mesh load_obj(std::string text, const std::string& file) {
    check_obj(text, file);
    std::istringstream stream(std::move(text));
    ObjReading reading;
    reading.file = file;
    std::string error;
    if (!tinyobj::LoadObjWithCallback(stream, obj_calls(), &reading, nullptr, nullptr, &error))
        throw file_error(file, "not an OBJ file: " + error);
    drop_plain_sources(reading.polygons, reading.mesh);
    if (!reading.every_corner_has_uv) reading.mesh.uvs.clear();
    return std::move(reading.mesh);
}

Mesh from_assimp(const aiMesh& source, const std::string& file) {
    Mesh mesh;
    mesh.first_number = 0;  // as PLY counts
    for (unsigned v = 0; v < source.mNumVertices; ++v) {
        const aiVector3D& p = source.mVertices[v];
        mesh.positions.push_back({p.x, p.y, p.z});
        if (source.HasTextureCoords(0))
            mesh.uvs.push_back({source.mTextureCoords[0][v].x, source.mTextureCoords[0][v].y});
    }
    for (unsigned f = 0; f < source.mNumFaces; ++f) {
        const std::span indices(source.mFaces[f].mIndices, source.mFaces[f].mNumIndices);
        if (indices.size() < 3)
            throw file_error(file, fmt::format("face {} has {} corners: at least 3 are needed", f,
                                               indices.size()));
        std::vector<PolygonCorner> corners;
        for (const unsigned index : indices) corners.push_back({index, index});
        add_polygon(corners, f, mesh);
    }
    drop_plain_sources(source.mNumFaces, mesh);
    return mesh;
}

Mesh load_ply(const std::string& bytes, const std::string& file) {
    const std::string checked = check_ply(bytes, file);
    const std::unique_ptr<const aiScene, void (*)(const aiScene*)> scene(
        aiImportFileFromMemory(checked.data(), static_cast<unsigned>(checked.size()), 0, "ply"),
        &aiReleaseImport);
    if (!scene) throw file_error(file, fmt::format("not a PLY mesh: {}", aiGetErrorString()));
    if (scene->mNumMeshes != 1) throw file_error(file, "the mesh has no faces");
    return from_assimp(*scene->mMeshes[0], file);
}

}  // namespace

Mesh load_mesh(const std::filesystem::path& path) {
    const std::string file = path.string();
    std::string ending = path.extension().string();
    for (char& letter : ending)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    if (ending != ".obj" && ending != ".ply")
        throw file_error(file, "a mesh file's name must end in .obj or .ply");
    std::string bytes = read_bytes(path);
    Mesh mesh = ending == ".obj" ? load_obj(std::move(bytes), file) : load_ply(bytes, file);
    check_mesh(mesh, file);
    return mesh;
}

}  // namespace weft
