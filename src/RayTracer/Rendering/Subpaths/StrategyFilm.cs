using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Rendering;

/// <summary>
/// What each way to make paths brings to a picture (Veach 1997, figure 10.4): with its weight, where all of them add up to the picture, and alone, as
/// if no other way made such paths. Sums are integers, which are the same in any order.
/// </summary>
internal sealed class StrategyFilm : IArrivals
{
    /// <summary>The edges of the longest paths that have layers; the light of longer ones is in the layer <see cref="Longer"/>.</summary>
    public const int LongestPath = 6;

    /// <summary>The name of the layer of longer paths.</summary>
    public const string Longer = "longer";

    private const int Stride = LongestPath + 2;
    private readonly Film _film;
    private readonly SplatSums[] _weighted;
    private readonly SplatSums[] _alone;
    private readonly int[] _layerOf = new int[2 * Stride * Stride];

    /// <summary>Makes empty layers.</summary>
    /// <param name="film">The film that they stand beside: it has the numbers of samples.</param>
    /// <param name="scene">The scene, rendered by an integrator that makes paths in several ways.</param>
    /// <exception cref="ArgumentException">It is rendered by another.</exception>
    public StrategyFilm(Film film, Scene scene)
    {
        _film = film;
        Strategies = [.. Of(scene)];
        SplatSums Sums() => new(film.Width, film.Height);
        _weighted = [.. Strategies.Select(_ => Sums()), Sums()];
        _alone = [.. Strategies.Select(_ => Sums())];
        Array.Fill(_layerOf, Strategies.Count);
        for (int i = 0; i < Strategies.Count; i++)
        {
            _layerOf[Place((uint)Strategies[i].Light, (uint)Strategies[i].Camera, Strategies[i].IsMerge)] = i;
        }
    }

    /// <summary>The ways that have layers.</summary>
    public IReadOnlyList<PathStrategy> Strategies { get; }

    /// <summary>All layers, and their names in files.</summary>
    public IEnumerable<(string Name, IImageRows Image)> Layers =>
    [
        .. Strategies.SelectMany(s => new[] { ($"{s.Name}.weighted", Image(s, isWeighted: true)), ($"{s.Name}.unweighted", Image(s, isWeighted: false)) }),
        (Longer, new Rows(_film, _weighted[^1])),
    ];

    /// <summary>Memory in bytes of the layers of a scene.</summary>
    public static long Bytes(Scene scene) =>
        (long)scene.Render.Width * scene.Render.Height * SplatSums.BytesPerPixel * ((2 * Of(scene).Count()) + 1);

    /// <summary>What a way brings.</summary>
    /// <param name="strategy">The way.</param>
    /// <param name="isWeighted">True for its share of the picture; else alone.</param>
    public IImageRows Image(PathStrategy strategy, bool isWeighted) => new Rows(_film, (isWeighted ? _weighted : _alone)[Strategies.ToList().IndexOf(strategy)]);

    /// <inheritdoc/>
    public void Add(uint pixel, in Arrival arrival)
    {
        int layer = arrival is { From: < Stride, To: < Stride } ? _layerOf[Place(arrival.From, arrival.To, arrival.IsMerge)] : Strategies.Count;
        _weighted[layer].Add(pixel, arrival.Light);
        if (layer < _alone.Length)
        {
            _alone[layer].Add(pixel, arrival.Alone);
        }
    }

    private static int Place(uint light, uint camera, bool isMerge) => (int)((((isMerge ? 1 : 0) * Stride) + light) * Stride + camera);

    private static IEnumerable<PathStrategy> Of(Scene scene) => scene.Render.Integrator is LightTracingIntegrator traced
        ? PathStrategy.Of(traced.Strategies, scene.Render.MaxDepth < 0 ? LongestPath : Math.Min(scene.Render.MaxDepth, LongestPath))
        : throw new ArgumentException(
            $"{Integrator.Only(IntegratorTraits.TracesLight, "make")} paths from the lights too, and the scene's is {scene.Render.Integrator}.", nameof(scene));

    private sealed class Rows(Film film, SplatSums sums) : IImageRows
    {
        public int Width => film.Width;

        public int Height => film.Height;

        public void ReadRow(int y, Span<float> rgb)
        {
            for (int i = 0; i < 3 * Width; i++)
            {
                uint count = film.SampleCount(i / 3, y);
                rgb[i] = count == 0 ? 0 : (float)(Film.ToDouble(sums.Sum((3L * y * Width) + i)) / (Film.ChannelUnits * count));
            }
        }
    }
}
