/// A glTF file taken apart: its JSON with paths for errors, the buffers that it names, and the numbers of its accessors. readGltf makes a mesh of them.
#pragma once
#include "meshes/readers/readers.hpp"
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace sph
{

/// A place in the JSON text, with the path to it for errors.
class GltfNode
{
    const nlohmann::json* json_;
    std::string path_;

    [[noreturn]] void refuse(const std::string& what) const { throw UnusableMesh(fmt::format("{}: {}", path_, what)); }

public:
    GltfNode(const nlohmann::json& json, std::string path) : json_(&json), path_(std::move(path)) {}

    const std::string& path() const { return path_; }

    std::optional<GltfNode> find(const char* key) const
    {
        if (!json_->is_object()) refuse("expected { ... }");
        const auto there = json_->find(key);
        return there == json_->end() ? std::nullopt : std::optional(GltfNode(*there, path_.empty() ? key : path_ + "." + key));
    }
    GltfNode at(const char* key) const
    {
        const auto there = find(key);
        if (!there) throw UnusableMesh(fmt::format("{}{}\"{}\" is missing", path_, path_.empty() ? "" : ": ", key));
        return *there;
    }
    std::size_t size() const
    {
        if (!json_->is_array()) refuse("expected [ ... ]");
        return json_->size();
    }
    GltfNode operator[](std::size_t i) const
    {
        if (i >= size()) refuse(fmt::format("there is no number {} of {}", i, size()));
        return {(*json_)[i], fmt::format("{}[{}]", path_, i)};
    }
    std::size_t whole() const
    {
        if (!json_->is_number_unsigned()) refuse("expected a whole number");
        return json_->get<std::size_t>();
    }
    double number() const
    {
        if (!json_->is_number()) refuse("expected a number");
        return json_->get<double>();
    }
    bool flag() const
    {
        if (!json_->is_boolean()) refuse("expected true or false");
        return json_->get<bool>();
    }
    const std::string& text() const
    {
        if (!json_->is_string()) refuse("expected a text");
        return json_->get_ref<const std::string&>();
    }
    std::size_t whole(const char* key, std::size_t otherwise) const
    {
        const auto there = find(key);
        return there ? there->whole() : otherwise;
    }
    std::string text(const char* key) const
    {
        const auto there = find(key);
        return there ? there->text() : "";
    }
    template<std::size_t n> std::array<double, n> numbers(const char* key, const std::array<double, n>& otherwise) const
    {
        const auto there = find(key);
        if (!there) return otherwise;
        if (there->size() != n) there->refuse(fmt::format("expected {} numbers", n));
        std::array<double, n> all;
        for (std::size_t i = 0; i < n; ++i) all[i] = (*there)[i].number();
        return all;
    }
    /// Throws UnusableMesh where it has an extension that changes the geometry.
    void checkExtensions() const;
};

class GltfFile
{
public:
    /// Reads the JSON, of a .glb too; `bytes` must outlive this. Throws UnusableMesh with the byte or the path of what is wrong.
    GltfFile(const std::filesystem::path& file, std::string_view bytes, Notes&);
    GltfFile(const GltfFile&) = delete; // nodes refer to its JSON

    const GltfNode& root() const { return root_; }
    struct Numbers
    {
        std::vector<double> values;
        bool single; ///< in single precision
    };
    /// All components of all elements of an accessor.
    Numbers numbers(std::size_t accessor, const std::string& type, std::size_t components);

private:
    /// Elements of `size` bytes of a bufferView, from `offset` on.
    struct Elements
    {
        const char* begin = nullptr;
        std::size_t stride = 0;
    };
    const std::filesystem::path& file_;
    nlohmann::json json_;
    GltfNode root_{json_, ""};
    std::optional<std::string_view> binary_; ///< the second part of a .glb
    std::vector<std::optional<std::string>> buffers_;

    std::string_view openBinary(std::string_view bytes, Notes&);
    std::string_view buffer(std::size_t index);
    std::string load(const GltfNode& uri) const;
    Elements elements(std::size_t view, std::size_t offset, std::size_t count, std::size_t size, const std::string& where);
};

}
