#include "case/cloudViews.hpp"

namespace sph
{

FieldView positionsOf(const Cloud& cloud) { return {"positions", FieldClass::vector, {cloud.x.data(), cloud.y.data(), cloud.z.data()}}; }

std::vector<FieldView> fieldsOf(const Cloud& cloud)
{
    std::vector<FieldView> views;
    for (const auto& [name, field] : cloud.fields)
    {
        auto& view = views.emplace_back(FieldView{name, field.type, {}});
        for (const auto& values : field.component) view.component.push_back(values.data());
    }
    return views;
}

}
