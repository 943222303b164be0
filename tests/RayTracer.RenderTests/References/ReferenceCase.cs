using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.RenderTests.References;

/// <summary>
/// A scene of the references, and which renders of it have the same expectation. The other renderer limits the edges of a
/// path: with at most k, a path has n &lt; k vertices on surfaces before it ends in a lamp or in the open. Here, diffuse and
/// specular bounces have a limit each, and each lit hit within them gets direct light, which is one edge more.
/// <para>
/// Without specular surfaces, direct light thus ends paths of n vertices after n − 1 bounces, and the background ends them after n:
/// the depth is k − 2 for lamps and k − 1 for the background. Light transport is linear, so the lamps' image and the
/// background's are rendered each with its depth, and added.
/// </para>
/// <para>
/// With specular surfaces, no two limits say n &lt; k. Then limits that allow no path too many and limits that forbid none
/// give two images, and as light is never negative, the truth lies between their expectations.
/// </para>
/// </summary>
/// <param name="Name">Name of the scene.</param>
/// <param name="Lower">Renders whose sum lacks no light, or lacks some.</param>
/// <param name="Upper">The same with no light missing, or some too much; null where <paramref name="Lower"/> is exact.</param>
public sealed record ReferenceCase(string Name, IReadOnlyList<ReferenceTerm> Lower, IReadOnlyList<ReferenceTerm>? Upper = null)
{
    /// <summary>The cases that this project's features can express.</summary>
    public static IReadOnlyList<ReferenceCase> All { get; } =
    [
        Diffuse("cornell", edges: 8, Sources.Lamps),
        Diffuse("directional", edges: 5, Sources.Lamps, Sources.Background),
        Diffuse("furnace_diffuse", edges: 20, Sources.Background),
        Specular("glass", edges: 12, diffuse: 3),
        Diffuse("instances", edges: 5, Sources.Lamps, Sources.Background),
        Mirror("mirror"),
        Diffuse("room_depth5", edges: 5, Sources.Lamps),
        Diffuse("sphere_lights", edges: 4, Sources.Lamps),
        Diffuse("tex_bilinear_scaled", edges: 3, Sources.Background),
        Diffuse("thinlens", edges: 5, Sources.Lamps, Sources.Background),
    ];

    /// <summary>The scene file.</summary>
    public string File => ProjectFolder.PathOf("tests", "RayTracer.RenderTests", "References", "scenes", $"{Name}.json");

    /// <summary>Renders the scene with independent seeds.</summary>
    /// <param name="seeds">How many.</param>
    /// <param name="samplesPerPixel">Samples in each pixel for each seed.</param>
    /// <param name="change">Changes the scene; null for none.</param>
    /// <param name="firstSeed">The first seed.</param>
    public ReferenceRenders Render(int seeds, int samplesPerPixel, Func<SceneDescription, SceneDescription>? change = null, long firstSeed = 1)
    {
        ImageSamples Sum(IReadOnlyList<ReferenceTerm> terms) => this.Sum(terms, seeds, samplesPerPixel, change, firstSeed);
        return new(Name, Sum(Lower), Upper is null ? null : Sum(Upper));
    }

    private static ReferenceCase Diffuse(string name, int edges, params Sources[] sources) =>
        new(name, [.. sources.Select(s => new ReferenceTerm(s, s == Sources.Lamps ? edges - 2 : edges - 1, 0))]);

    // At most D diffuse and S specular bounces, and then direct light: at most D + S + 1 vertices, and these are edges − 1.
    private static ReferenceCase Specular(string name, int edges, int diffuse) => new(
        name,
        [new(Sources.All, diffuse, edges - 2 - diffuse)],
        [new(Sources.All, edges - 1, edges - 1)]);

    // Floor and ball are convex, so light goes from one to the other in turn: of at most 7 vertices, at most 4 are on each. Limits of
    // 3 and 3 lack of these only the paths of 7 that leave after the fourth bounce off one of them; 4 and 4 have some of 8 or 9 too many.
    private static ReferenceCase Mirror(string name) => new(name, [new(Sources.All, 3, 3)], [new(Sources.All, 4, 4)]);

    private ImageSamples Sum(
        IReadOnlyList<ReferenceTerm> terms, int seeds, int samplesPerPixel, Func<SceneDescription, SceneDescription>? change, long firstSeed)
    {
        ImageSamples? images = null;
        for (int i = 0; i < seeds; i++)
        {
            long seed = (uint)(firstSeed + i + (TestSettings.Seed * 1_000_000L));
            Picture sum = terms.Select(term => Render(term, seed, samplesPerPixel, change)).Aggregate(Add);
            images ??= new(sum.Width, sum.Height);
            images.Add(sum);
        }

        return images ?? throw new ArgumentOutOfRangeException(nameof(seeds));
    }

    private Picture Render(ReferenceTerm term, long seed, int samplesPerPixel, Func<SceneDescription, SceneDescription>? change)
    {
        Film film = new RTracer(SceneRuns.Load(File, d => term.Apply(change?.Invoke(d) ?? d, seed, samplesPerPixel))).Render().Film;
        Picture picture = new(film.Width, film.Height);
        for (int y = 0; y < film.Height; y++)
        {
            film.ReadRow(y, picture.Pixels.AsSpan(3 * film.Width * y, 3 * film.Width));
        }

        return picture;
    }

    private static Picture Add(Picture a, Picture b) => new(a.Width, a.Height, [.. a.Pixels.Zip(b.Pixels, (x, y) => x + y)]);
}
