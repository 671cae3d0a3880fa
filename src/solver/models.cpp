#include "solver/models.hpp"
#include "integrators/Integrator.hpp"
#include "models/density/density.hpp"
#include "models/forces/forces.hpp"
#include "models/gas/gas.hpp"
#include "models/labels/labels.hpp"
#include "models/openings/openingsModel.hpp"
#include "models/pressure/pressure.hpp"
#include "models/scalarTransport/scalarTransport.hpp"
#include "models/shifting/shifting.hpp"
#include "models/soil/soil.hpp"
#include "models/suspension/suspension.hpp"
#include "models/tension/tension.hpp"
#include "models/thermal/thermal.hpp"
#include "models/viscosity/viscosity.hpp"
#include "models/walls/walls.hpp"
#include "operators/operatorTerms.hpp"
#include "solver/precision.hpp"

namespace sph
{

const std::vector<const Model*>& models()
{
    static const std::vector<const Model*> all{&openingsModel(),    &gasModel(),      &suspensionModel(), &scalarTransportModel(),
                                               &densityModel(),     &pressureModel(), &viscosityModel(),  &tensionModel(),
                                               &forcesModel(),      &shiftingModel(), &soilModel(),       &wallsModel(),
                                               &integrationModel(), &labelsModel(),   &thermalModel(),    &precisionModel()};
    return all;
}

template<int dim> const Catalogue<dim>& allTerms()
{
    static const Catalogue<dim> all = []
    {
        Catalogue<dim> terms = operatorTerms<dim>();
        for (const auto* model : models()) terms.insert(terms.end(), model->terms<dim>().begin(), model->terms<dim>().end());
        return terms;
    }();
    return all;
}

template const Catalogue<2>& allTerms<2>();
template const Catalogue<3>& allTerms<3>();

}
