// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the pores of a packing with a given mass of water.

#include "IOdictionary.H"
#include "argList.H"
#include "fvCFD.H"
#include "granularProperties.H"
#include "keywords.H"
#include "projectVersion.H"
#include "serialTool.H"
#include "solidFractionField.H"

using namespace Foam;

namespace
{
    dictionary caseDictionary
    (
        const fvMesh& mesh,
        const fileName& folder,
        const word& name
    )
    {
        return IOdictionary
        (
            IOobject
            (
                name,
                folder,
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE
            )
        );
    }


    //- The pores that the grains of the case leave
    class poresOfGrains
    {
        const granularProperties dict_;
        const autoPtr<granularPhase> phase_;
        grainExchange exchange_;
        solidFractionField solids_;

    public:

        poresOfGrains(const fvMesh& mesh, const vector& g)
        :
            dict_(mesh),
            phase_(dict_.makePhase(mesh, g)),
            exchange_(mesh),
            solids_(exchange_, keywords::sub(dict_, "voidFraction"))
        {
            exchange_.locate(*phase_);
        }

        //- Their volume in each cell [m3], with this water fraction of the cells: the
        //  smoothing ends at its surface
        scalarField volumes(const scalarField& water)
        {
            solids_.setWater(water);
            solids_.update();

            return (1 - solids_.solidFraction())*exchange_.mesh().V();
        }
    };


    boundBox boxOf(const fvMesh& mesh, const cell& c)
    {
        return boundBox(c.points(mesh.faces(), mesh.points()), false);
    }


    //- Share of each cell that lies in the box, up to the level along z [-]
    scalarField shares
    (
        const fvMesh& mesh,
        const boundBox& box,
        const scalar level
    )
    {
        scalarField result(mesh.nCells(), Zero);

        forAll(result, cell)
        {
            const boundBox cellBox(boxOf(mesh, mesh.cells()[cell]));
            point centre(mesh.C()[cell]);
            centre.z() = box.min().z();

            if (box.contains(centre))
            {
                const scalar bottom = max(cellBox.min().z(), box.min().z());
                const scalar top = min(cellBox.max().z(), level);

                result[cell] =
                    max(top - bottom, scalar(0))/cellBox.span().z();
            }
        }

        return result;
    }


    //- How far sides of the ground plan reach into cells that the box meets below the
    //  level [m]; 0 where they are between cells
    scalar besidePlan
    (
        const fvMesh& mesh,
        const boundBox& box,
        const scalar level
    )
    {
        const point top(box.max().x(), box.max().y(), level);
        scalar most = 0;
        for (const cell& c : mesh.cells())
        {
            const boundBox b(boxOf(mesh, c));
            if (cmptMin(min(b.max(), top) - max(b.min(), box.min())) <= 0)
            {
                continue;
            }
            for (const direction d : {vector::X, vector::Y})
            {
                for (const scalar side : {box.min()[d], box.max()[d]})
                {
                    const scalar cut = min(side - b.min()[d], b.max()[d] - side);
                    most = max(most, cut > 0.05*b.span()[d] ? cut : 0);
                }
            }
        }
        return most;
    }
}


//- Density of the liquid of a field alpha.<phase> [kg/m3]: that of the solver
scalar readDensity
(
    const fvMesh& mesh,
    const dictionary& settings,
    const word& field
)
{
    const word phase(field.substr(field.find('.') + 1));
    const scalar density = dimensionedScalar
    (
        "rho",
        dimDensity,
        caseDictionary(mesh, "constant", "transportProperties").subDict(phase)
    ).value();
    const scalar entry = settings.getOrDefault<scalar>("density", density);

    if (mag(entry - density) > 1e-6*density)
    {
        FatalIOErrorInFunction(settings)
            << "density is " << entry << " kg/m3 here and that of " << phase
            << " in constant/transportProperties " << density
            << ". Take it out here" << exit(FatalIOError);
    }
    return density;
}


//- Level [m] up to which pores in a box hold a mass of liquid; pores: volume of
//  those in each cell [m3]
scalar levelOf
(
    const scalar mass,
    const scalar density,
    const fvMesh& mesh,
    const boundBox& box,
    const scalarField& pores,
    const dictionary& settings
)
{
    const auto holds = [&](const scalar level)
    {
        return density*sum(pores*shares(mesh, box, level));
    };
    scalar low = box.min().z();
    scalar high = mesh.bounds().max().z();
    const scalar most = holds(high);

    if (mass > most)
    {
        FatalIOErrorInFunction(settings)
            << mass << " kg of water do not fit: the box " << box
            << " extended to the top of the mesh holds " << most << " kg."
            << nl << "    Give less water, or a higher mesh."
            << exit(FatalIOError);
    }

    while (high - low > 1e-12*mesh.bounds().mag())
    {
        const scalar level = 0.5*(low + high);
        (holds(level) > mass ? high : low) = level;
    }
    return low;
}


//- Level [m] up to which a box holds a mass of water between grains: it depends on
//  the pores, and these on the surface of the water. pores is set
scalar levelAmongGrains
(
    const scalar mass,
    const scalar density,
    const fvMesh& mesh,
    const boundBox& box,
    const vector& g,
    const dictionary& settings,
    scalarField& pores
)
{
    poresOfGrains grains(mesh, g);
    pores = grains.volumes(scalarField(mesh.nCells(), 1));
    scalar level = levelOf(mass, density, mesh, box, pores, settings);
    scalar change = GREAT;

    for (label n = 0; n < 100 && change > 1e-12*mesh.bounds().mag(); ++n)
    {
        pores = grains.volumes(shares(mesh, box, level));
        const scalar next = levelOf(mass, density, mesh, box, pores, settings);
        change = mag(next - level);
        level = next;
    }

    return level;
}


//- Warn where water stands beside the box
void warnOfWaterBeside(const fvMesh& mesh, const boundBox& box, const scalar level)
{
    const scalar beside = besidePlan(mesh, box, level);
    if (beside > 0)
    {
        WarningInFunction
            << "Sides of the box " << box << " cut cells of the mesh, which are"
            << " filled by their centre: the water stands up to " << beside
            << " m beside the box." << nl
            << "    Let cells end at its sides." << endl;
    }
}


//- Box and mass: a packing of constant/packingProperties, or the settings themselves
dictionary packingEntries(const fvMesh& mesh, const dictionary& settings)
{
    return
        settings.found("packing")
      ? caseDictionary(mesh, "constant", "packingProperties").subDict
        (
            settings.get<word>("packing")
        )
      : settings;
}


int main(int argc, char *argv[])
{
    Foam::answerVersion(argc, argv);
    argList::addNote
    (
        "Fills a box with a given mass of water, in the pores that the grains"
        " leave. Box and mass: a packing of constant/packingProperties, or the"
        " entries of system/fillWaterDict"
    );
    argList::noParallel();
    startSerialTool();

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"
    #include "readGravitationalAcceleration.H"

    const dictionary settings(caseDictionary(mesh, "system", "fillWaterDict"));
    keywords::check
    (
        settings,
        {"FoamFile", "packing", "min", "max", "fluidMass", "density", "field"}
    );

    const dictionary packing(packingEntries(mesh, settings));
    const boundBox box(packing.get<point>("min"), packing.get<point>("max"));
    const scalar mass = packing.get<scalar>("fluidMass");
    const word field(settings.getOrDefault<word>("field", "alpha.water"));
    const scalar density = readDensity(mesh, settings, field);

    volScalarField alpha
    (
        IOobject
        (
            field,
            runTime.timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        mesh
    );

    scalarField pores;
    const scalar level = levelAmongGrains
    (
        mass, density, mesh, box, g.value(), settings, pores
    );

    alpha.primitiveFieldRef() = shares(mesh, box, level);
    alpha.write();

    warnOfWaterBeside(mesh, box, level);
    Info<< "Water: " << density*sum(pores*alpha.primitiveField())
        << " kg, level at z = " << level << " m; top of the packing at "
        << box.max().z() << " m" << nl << endl;

    return 0;
}
