#include "models.hpp"
#include "Integrator.hpp"
#include "density.hpp"
#include "forces.hpp"
#include "labels.hpp"
#include "openingsModel.hpp"
#include "operatorTerms.hpp"
#include "pressure.hpp"
#include "scalarTransport.hpp"
#include "shifting.hpp"
#include "soil.hpp"
#include "suspension.hpp"
#include "tension.hpp"
#include "thermal.hpp"
#include "viscosity.hpp"
#include "walls.hpp"

namespace sph
{

const std::vector<const Model*>& models()
{
    static const std::vector<const Model*> all{&openingsModel(), &suspensionModel(), &scalarTransportModel(), &densityModel(),
                                               &pressureModel(), &viscosityModel(),  &tensionModel(),         &forcesModel(),
                                               &shiftingModel(), &soilModel(),       &wallsModel(),           &integrationModel(),
                                               &labelsModel(),   &thermalModel()};
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
