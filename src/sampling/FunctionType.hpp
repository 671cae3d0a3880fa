/// Types of function objects by name: those of this room, and those of libraries that a case names.
#pragma once
#include "sampling/FunctionContext.hpp"

namespace sph
{

/// A word for `type`, how an object of it is made, which entries it reads and which table it writes.
struct FunctionType
{
    ChoiceWord name;
    std::unique_ptr<FunctionObject> (*make)(const Dictionary&, const FunctionContext&);
    EntryList (*entries)();
    TableInfo (*table)();
};

/// The type of a class that is made of a Dictionary and a FunctionContext and has the static functions `entries` and `table`.
template<class Object> FunctionType functionType(const char* name, const char* meaning)
{
    return {{name, meaning},
            [](const Dictionary& d, const FunctionContext& context) -> std::unique_ptr<FunctionObject>
            { return std::make_unique<Object>(d, context); },
            Object::entries,
            Object::table};
}

/// All that there are now, those of loaded libraries last.
const std::vector<FunctionType>& functionTypes();

/// Adds a type while it is constructed: a constant of a library does so while the library is loaded.
struct AddedFunction
{
    explicit AddedFunction(const FunctionType&);
};

}
