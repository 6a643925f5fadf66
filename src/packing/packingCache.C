// SPDX-License-Identifier: GPL-3.0-or-later
// Packings kept from earlier runs, found by their specification.

#include "packingCache.H"
#include "clumpTable.H"
#include "grainsData.H"
#include "OSHA1stream.H"
#include "OSspecific.H"
#include "clockTime.H"

namespace
{

//- To be raised when the same entries give other grains
constexpr int generation = 1;

const Foam::word dataName("grains.data");

//- How the clumps are turned
const Foam::word clumpsName("grains.clumps");


//- Make the packing in a folder of this process, then give it its name
Foam::packedGrains make
(
    const Foam::packingModel& model,
    const Foam::fileName& folder
)
{
    using namespace Foam;

    const fileName aside(folder + "." + Foam::name(pid()));
    if (!mkDir(aside))
    {
        FatalErrorInFunction
            << "Cannot make the folder " << aside << " to keep packings in;"
            << " set INTERDEMFOAM_CACHE to a folder that can be written to"
            << exit(FatalError);
    }

    const packedGrains grains(model.make(aside));
    writeGrainsData
    (
        aside/dataName,
        grains,
        model.box().bounds(),
        "Grains of a packing of type " + model.type()
    );
    if (model.clump())
    {
        writeClumpTable
        (
            aside/clumpsName,
            placedClumps(model.clump()->name(), grains)
        );
    }
    rm(aside/"settling.data");

    // Either an incomplete one lies there, or another process was faster
    rmDir(folder, true);
    mv(aside, folder);
    return grains;
}

} // End anonymous namespace


Foam::fileName Foam::packingCache::root()
{
    fileName cache(getEnv("INTERDEMFOAM_CACHE"));
    if (cache.empty())
    {
        const fileName xdg(getEnv("XDG_CACHE_HOME"));
        cache = (xdg.empty() ? home()/".cache" : xdg)/"interDEMFoam";
    }
    return cache/"packings";
}


Foam::fileName Foam::packingCache::folder(const packingModel& model)
{
    OSHA1stream os;
    os << generation << nl;
    model.writeKey(os);
    return root()/os.digest().str();
}


Foam::packedGrains Foam::packingCache::obtain(const packingModel& model)
{
    const fileName kept(folder(model));
    packedGrains grains;

    // A folder that lacks its clumps was not written to its end
    const bool isWhole = !model.clump() || isFile(kept/clumpsName);
    if (isWhole && readGrainsData(kept/dataName, grains))
    {
        if (model.clump())
        {
            for (const placedClump& clump : readClumpTable(kept/clumpsName))
            {
                grains.orientation.append(clump.orientation);
            }
            if (grains.orientation.size() != grains.size())
            {
                FatalErrorInFunction
                    << "The kept packing " << kept << " has " << grains.size()
                    << " grains, but orientations of " << grains.orientation.size()
                    << "." << nl << "    Remove that folder." << exit(FatalError);
            }
        }
        Info<< "    kept in " << kept << endl;
        return grains;
    }

    clockTime timer;
    grains = make(model, kept);
    Info<< "    made in " << timer.elapsedTime() << " s, kept in " << kept
        << endl;
    return grains;
}
