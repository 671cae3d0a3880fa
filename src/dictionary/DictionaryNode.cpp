#include "dictionary/DictionaryNode.hpp"
#include "dictionary/limits.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

using Node = Dictionary::Node;

std::shared_ptr<Node> Node::child(const std::string& key, const Location& at)
{
    auto node = std::make_shared<Node>();
    node->name = name + "." + key;
    node->keyword = key;
    node->where = at;
    node->diagnostics = diagnostics;
    node->caseFolder = caseFolder;
    node->parent = this;
    return node;
}

DictionaryEntry* Node::findExact(const std::string& key)
{
    for (; placed_ < entries.size(); ++placed_) places_.try_emplace(entries[placed_].keyword, placed_);
    const auto place = places_.find(key);
    return place == places_.end() ? nullptr : &entries[place->second];
}

DictionaryEntry* Node::find(const std::string& key)
{
    if (auto* exact = findExact(key)) return exact;
    DictionaryEntry* latest = nullptr;
    for (auto e = entries.rbegin(); e != entries.rend(); ++e)
        if (e->pattern && (!latest || e->given > latest->given) && e->pattern->matches(key)) latest = &*e;
    return latest;
}

/// A keyword may itself hold dots ("alpha.water"): the whole name is tried first, then each dot as the separator. A pattern
/// such as "p.*" would match any path that begins with p, so that patterns see whole paths last.
DictionaryEntry* Node::descend(const std::string& path, Vain& vain)
{
    if (auto* entry = findExact(path)) return entry;
    if (!vain.emplace(this, path.size()).second) return nullptr;
    for (auto dot = path.find('.'); dot != path.npos; dot = path.find('.', dot + 1))
        if (auto* entry = find(path.substr(0, dot)); entry && entry->dictionary)
            if (auto* inner = entry->dictionary->descend(path.substr(dot + 1), vain))
            {
                entry->used = true;
                return inner;
            }
    return find(path);
}

DictionaryEntry* Node::descend(const std::string& path)
{
    Vain vain;
    return descend(path, vain);
}

DictionaryEntry* Node::findScoped(const std::string& path)
{
    if (path.starts_with('/'))
    {
        auto dotted = path;
        std::replace(dotted.begin(), dotted.end(), '/', '.');
        return findScoped(dotted.replace(0, 1, ":"));
    }
    if (path.starts_with(':'))
    {
        auto* top = this;
        while (top->parent) top = top->parent;
        return top->descend(path.substr(1));
    }
    if (path.starts_with('.'))
    {
        auto* scope = this;
        std::size_t dots = 1;
        for (; dots < path.size() && path[dots] == '.'; ++dots)
            if (scope) scope = scope->parent;
        return scope ? scope->descend(path.substr(dots)) : nullptr;
    }
    for (auto* scope = this; scope; scope = scope->parent)
        if (auto* entry = scope->descend(path)) return entry;
    return nullptr;
}

namespace
{
/// "the macro in d:3", "the macros in d:3, d:4, .."
std::string takers(const DictionaryEntry& entry)
{
    constexpr std::size_t most = 5;
    std::string places;
    for (std::size_t k = 0; k < std::min(most, entry.taken.size()); ++k) places += (k ? ", " : "") + toString(entry.taken[k]);
    if (entry.taken.size() > most) places += fmt::format(" and {} more", entry.taken.size() - most);
    return (entry.taken.size() > 1 ? "the macros in " : "the macro in ") + places;
}

bool sameValue(const DictionaryEntry& a, const DictionaryEntry& b)
{
    const auto same = [](const Token& s, const Token& t) { return s.kind == t.kind && s.text == t.text && s.dictionary == t.dictionary; };
    return a.dictionary == b.dictionary && std::ranges::equal(a.value, b.value, same);
}
}

void Node::add(DictionaryEntry entry, InputMode mode)
{
    if (entry.dictionary) entry.dictionary->parent = this;
    entry.given = ++given_;
    auto* before = findExact(entry.keyword);
    if (!before)
    {
        entries.push_back(std::move(entry));
        return;
    }
    const auto previous = fmt::format("\"{}\" is given twice, first in {}", entry.keyword, toString(before->where));
    switch (mode)
    {
    case InputMode::protect:
        return;
    case InputMode::warn:
        diagnostics->warning(entry.where, previous + ", which is kept");
        return;
    case InputMode::error:
        diagnostics->error(entry.where, previous);
        return;
    case InputMode::merge:
        if (before->dictionary && entry.dictionary)
        {
            if (!before->taken.empty() && !entry.dictionary->entries.empty())
                diagnostics->warning(entry.where, previous + "; what is added here comes too late for " + takers(*before));
            for (auto& inner : entry.dictionary->entries) before->dictionary->add(std::move(inner), mode);
            if (entry.copied || (!before->copied && entry.where.file != before->where.file)) return;
            // New entries would be written into the last block of the text that is this dictionary's own.
            before->where = before->copied ? entry.where : before->where;
            before->copied = false;
            before->dictionary->end = entry.dictionary->end;
            before->begin = entry.begin;
            before->end = entry.end;
            return;
        }
        break;
    case InputMode::overwrite:
        break;
    }
    // Overriding a macro's or an included file's value is the usual way to vary a base case; the same keyword twice in one
    // block is most likely a slip.
    // A macro's value is fixed where the macro stands, as in OpenFOAM.
    if (!before->taken.empty() && !sameValue(*before, entry))
        diagnostics->warning(entry.where, previous + "; the last one counts, but comes too late for " + takers(*before));
    else if (mode == InputMode::merge && !before->copied && !entry.copied && before->where.file == entry.where.file &&
             before->where.line != entry.where.line)
        diagnostics->warning(entry.where, previous + "; the last one counts");
    entry.used = entry.used || before->used;
    *before = std::move(entry);
}

void Node::mergeCopies(const Node& other)
{
    const auto originals = other.entries; // the two may be the same dictionary
    for (auto copy : originals)
    {
        copy.copied = true;
        copy.used = copy.ignored = false;
        copy.taken.clear();
        const auto duplicate = [&](std::shared_ptr<Node>& inner)
        {
            auto own = child(inner->keyword, inner->where);
            own->end = inner->end;
            own->mergeCopies(*inner);
            inner = own;
        };
        if (copy.dictionary) duplicate(copy.dictionary);
        for (auto& token : copy.value)
            if (token.dictionary) duplicate(token.dictionary);
        add(std::move(copy), InputMode::merge);
    }
}

namespace
{
using Extent = Node::Extent;
void measure(const std::vector<Token>&, int level, Extent&);

void measure(const Node& node, int level, Extent& all)
{
    all.levels = std::max(all.levels, level);
    for (const auto& e : node.entries)
    {
        if (++all.words > limit::words || level > limit::nesting) return;
        if (e.dictionary) measure(*e.dictionary, level + 1, all);
        measure(e.value, level, all);
    }
}

void measure(const std::vector<Token>& value, int level, Extent& all)
{
    all.words += value.size();
    for (const auto& token : value)
        if (all.words > limit::words) return;
        else if (token.dictionary) measure(*token.dictionary, level + 1, all);
}
}

Extent Node::extent() const
{
    Extent all;
    measure(*this, 1, all);
    return all;
}

Extent extentOf(const std::vector<Token>& value)
{
    Extent all;
    measure(value, 0, all);
    return all;
}

void Node::lookUp(const std::string& key)
{
    visited = true;
    if (lookUpLog) lookUpLog->emplace_back(name, key);
    if (std::find(lookedUp.begin(), lookedUp.end(), key) == lookedUp.end()) lookedUp.push_back(key);
}

}
