/// constant/transportProperties: what moves relative to the flow. Scenes without the file have nothing of it.
#pragma once
#include "EntryList.hpp"
#include "Settings.hpp"

namespace sph
{

void readTransport(const Case&, Settings&);
EntryList transportEntries();

}
