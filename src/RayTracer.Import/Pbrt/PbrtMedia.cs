using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>Fills shapes.</summary>
/// <param name="reading">Takes what is wrong.</param>
/// <param name="world">The things of the scene.</param>
/// <param name="exposure">The factor of the film on all light: the imaging ratio.</param>
internal sealed class PbrtMedia(ImportReading reading, PbrtWorld world, float exposure)
{
    private static readonly string[] s_types = ["homogeneous", "uniformgrid", "rgbgrid", "cloud", "nanovdb"];

    private readonly Dictionary<PbrtThing, MediumDescription> _made = [];
    private readonly HashSet<string> _used = [];

    /// <summary>Reads all media, so that mistakes in those that fill nothing are found too; and says where the camera stands in one that fills nothing.</summary>
    public void ReadAll()
    {
        foreach (PbrtThing medium in world.Media.Values)
        {
            Read(medium);
        }

        if (world.Only.GetValueOrDefault("camera") is { State.Outside: { Length: > 0 } around } camera && !_used.Contains(around))
        {
            reading.Log.Unsupported(camera.Place, $"the medium {Quotation.Of(around)} around the camera fills no shape: media without a boundary are not supported", "it is left out");
        }
    }

    /// <summary>The material of a shape with what is inside; the material itself where nothing is.</summary>
    public MaterialDescription Fill(PbrtThing shape, MaterialDescription material)
    {
        string inside = shape.State.Inside;
        if (inside.Length == 0 || inside == shape.State.Outside)
        {
            return material;
        }

        if (!world.Media.TryGetValue(inside, out PbrtThing? medium))
        {
            reading.Log.Unknown(shape.Place, $"there is no medium {Quotation.Of(inside)}", inside, world.Media.Keys);
            return material;
        }

        _used.Add(inside);
        if (FilledMaterials.Fill(material, Read(medium)) is { } filled)
        {
            return filled;
        }

        if (material is not DiffuseMaterialDescription)
        {
            reading.Log.Warn(shape.Place, "a medium in a shape that lets no light in is invisible");
        }

        return material;
    }

    private MediumDescription Read(PbrtThing medium)
    {
        if (!_made.TryGetValue(medium, out MediumDescription? made))
        {
            made = Make(medium);
            medium.Finish();
            _made.Add(medium, made);
        }

        return made;
    }

    private MediumDescription Make(PbrtThing medium)
    {
        if (!s_types.Contains(medium.Type))
        {
            medium.UnknownType(s_types);
            return new();
        }

        medium.Refuse("preset", "the named media of pbrt are not read: \"sigma_a\" and \"sigma_s\" say what they are");
        float scale = medium.Float("scale", 1, 0);
        if (medium.Type == "rgbgrid")
        {
            return Colored(medium, scale);
        }

        Rgb absorption = PbrtColors.Read(medium, "sigma_a", Rgb.White) * scale;
        Rgb scattering = PbrtColors.Read(medium, "sigma_s", Rgb.White) * scale;
        Rgb extinction = absorption + scattering;
        GridDescription? density = medium.Type switch { "uniformgrid" => Grid(medium, medium.Floats("density"), 1, "density"), "nanovdb" => File(medium, "density"), _ => null };
        GridDescription? heat = Temperatures(medium, density);
        float coldest = medium.Float("temperatureoffset", medium.Float("temperaturecutoff", 0));
        float kelvins = medium.Float("temperaturescale", 1, 0);
        bool isScaled = medium.Type == "uniformgrid" && medium.Parameter("Lescale") is { Numbers.Count: > 1 };
        GridDescription? glow = isScaled ? Glow(medium) : null;
        Rgb radiance = Emission(medium, heat is not null, isScaled);
        bool shines = !(absorption * radiance).IsBlack;
        bool glows = heat is not null && shines;
        return new()
        {
            Extinction = extinction,
            Albedo = new(Part(scattering.R, extinction.R), Part(scattering.G, extinction.G), Part(scattering.B, extinction.B)),
            Anisotropy = medium.Float("g", 0, -0.99f, 0.99f),
            Emission = absorption * radiance,
            EmissionGrid = shines ? glow : null,
            TemperatureGrid = glows ? heat : null,
            TemperatureOffset = glows ? coldest : 0,
            TemperatureScale = glows ? kelvins : 1,
            Density = density,
            Cloud = medium.Type == "cloud" ? Cloud(medium) : null,
        };
    }

    // Of a NanoVDB file they are a grid of that name, if it has one.
    private static GridDescription? Temperatures(PbrtThing medium, GridDescription? density) => medium.Type switch
    {
        "uniformgrid" when medium.Has("temperature") => Grid(medium, medium.Floats("temperature"), 1, "temperature"),
        "nanovdb" when density is { File: var file } && VolumeFile.Has(file, "temperature") => File(medium, "temperature"),
        _ => null,
    };

    // Of each point, the density times its factor on the radiance.
    private static GridDescription? Glow(PbrtThing medium)
    {
        IReadOnlyList<float> factors = medium.Floats("Lescale");
        IReadOnlyList<float> densities = medium.Floats("density");
        return Grid(medium, [.. factors.Select((f, i) => i < densities.Count ? f * densities[i] : f)], 1, "Lescale");
    }

    // For each unit of length, what is absorbed of a radiance: pbrt's media shine like bodies of that radiance.
    private Rgb Emission(PbrtThing medium, bool isHot, bool isScaled)
    {
        Rgb radiance = PbrtColors.Read(medium, "Le", isHot ? Rgb.White : Rgb.Black, isLight: true);
        if (isHot && medium.Has("Le"))
        {
            medium.Log.Error(medium.PlaceOf("Le"), "a medium has either \"Le\" or temperatures, not both");
        }

        return radiance * (isScaled ? exposure : medium.Float("Lescale", 1, 0) * exposure);
    }

    private static float Part(float scattering, float extinction) => extinction > 0 ? float.Min(scattering / extinction, 1) : 0;

    private static GridDescription? File(PbrtThing medium, string name)
    {
        if (medium.FileName() is not { } file)
        {
            return null;
        }

        return new() { File = file, Name = name, Transform = MatrixSteps.Of(medium.State.Place) };
    }

    private static CloudDescription Cloud(PbrtThing medium) => new()
    {
        Box = [medium.Vector("p0", "point3") ?? Vector3.Zero, medium.Vector("p1", "point3") ?? Vector3.One],
        Transform = MatrixSteps.Of(medium.State.Place),
        Density = medium.Float("density", 1, 0),
        Wispiness = medium.Float("wispiness", 1, 0),
        Frequency = medium.Float("frequency", 5, 0),
    };

    // Of each point, the extinction, the part of it that is scattered, and the light that is sent for each unit of length. What is not given is 1.
    private MediumDescription Colored(PbrtThing medium, float scale)
    {
        IReadOnlyList<float> absorbed = PbrtColors.Many(medium, "sigma_a");
        IReadOnlyList<float> scattered = PbrtColors.Many(medium, "sigma_s");
        IReadOnlyList<float> shining = PbrtColors.Many(medium, "Le");
        float strength = medium.Float("Lescale", 1, 0) * exposure;
        int count = int.Max(absorbed.Count, scattered.Count);
        if (count == 0 || (absorbed.Count > 0 && scattered.Count > 0 && absorbed.Count != scattered.Count) || (shining.Count > 0 && shining.Count != absorbed.Count))
        {
            medium.Log.Error(medium.Place, "an rgbgrid needs \"sigma_a\" or \"sigma_s\", as many of both, and as many of \"Le\" as of \"sigma_a\" where it shines");
            return new();
        }

        float At(IReadOnlyList<float> values, int i) => values.Count > 0 ? values[i] : 1;
        if (Grid(medium, [.. Enumerable.Range(0, count).Select(i => At(absorbed, i) + At(scattered, i))], 3, absorbed.Count > 0 ? "sigma_a" : "sigma_s") is not { } density)
        {
            return new();
        }

        MediumDescription made = new()
        {
            Extinction = new(scale, scale, scale),
            Albedo = Rgb.White,
            Anisotropy = medium.Float("g", 0, -0.99f, 0.99f),
            Density = density,
            AlbedoGrid = Grid(medium, [.. Enumerable.Range(0, count).Select(i => Part(At(scattered, i), At(absorbed, i) + At(scattered, i)))], 3, "sigma_s", layer: 0),
        };
        return shining.All(l => l * strength == 0) ? made : made with
        {
            Emission = new(scale * strength, scale * strength, scale * strength),
            EmissionGrid = Grid(medium, [.. shining.Select((l, i) => l * absorbed[i])], 3, "Le"),
        };
    }

    // Beyond the outermost points there is nothing, and in between it fades: a layer of points without density around the grid, as pbrt has it.
    private static GridDescription? Grid(PbrtThing medium, IReadOnlyList<float> values, int channels, string name, int layer = 1)
    {
        (int x, int y, int z) = (medium.Integer("nx", 1, 1), medium.Integer("ny", 1, 1), medium.Integer("nz", 1, 1));
        Vector3 first = medium.Vector("p0", "point3") ?? Vector3.Zero;
        Vector3 last = medium.Vector("p1", "point3") ?? Vector3.One;
        if (VolumeGrid.SizeComplaint(x + 2L, y + 2L, z + 2L, channels) is { } complaint)
        {
            return medium.Log.Fail<GridDescription>(medium.Place, complaint);
        }

        if (values.Count != (long)channels * x * y * z)
        {
            string points = channels == 1 ? "" : $"{channels}·";
            return medium.Log.Fail<GridDescription>(medium.PlaceOf(name), $"expected {points}nx·ny·nz = {(long)channels * x * y * z} numbers for {Quotation.Of(name)}, but found {values.Count}");
        }

        (int nx, int ny, int nz) = (x + (2 * layer), y + (2 * layer), z + (2 * layer));
        long count = (long)channels * nx * ny * nz;
        if (SceneBudget.Open?.Take("the grid of densities", 4 * count, count) is { } tooMuch)
        {
            return medium.Log.Fail<GridDescription>(medium.PlaceOf(name), tooMuch);
        }

        float[] padded = new float[count];
        for (int i = 0; i < values.Count; i++)
        {
            (int row, int column) = (i / channels / x, i / channels % x);
            padded[(channels * ((((((long)(row / y) + layer) * ny) + (row % y) + layer) * nx) + column + layer)) + (i % channels)] = values[i];
        }

        Vector3 cell = (last - first) / new Vector3(x, y, z);
        int[] size = channels == 1 ? [nx, ny, nz] : [nx, ny, nz, channels];
        return new() { Size = size, Values = padded, Box = [first - (layer * cell), last + (layer * cell)], Transform = MatrixSteps.Of(medium.State.Place) };
    }
}
