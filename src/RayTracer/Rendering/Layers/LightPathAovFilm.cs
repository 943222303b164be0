using System.Runtime.InteropServices;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Rendering;

/// <summary>
/// Layers of light beside a film: what of its picture comes from which source, or in which way. Sums are exact, as the film's are, and in its units. Of
/// every sample, the layers add up to what the film takes, to the last unit: what rounding leaves goes to the layer that has most.
/// </summary>
public sealed class LightPathAovFilm
{
    /// <summary>The most layers of <see cref="LightPathAov.Lights"/>.</summary>
    public const int MostLights = 64;

    // Of all layers that a scene has, where each is among those that are kept; −1 for others.
    private readonly int[] _place;

    // Of the latest pass, which may be taken back, and of those before: the upper halves of 128 bits only where they are needed.
    private readonly long[][] _pass;
    private readonly long[][] _sums;
    private readonly int[]?[] _upper;
    private readonly Film _film;

    /// <summary>Makes empty layers.</summary>
    /// <param name="film">The film that they stand beside: it has the size and the numbers of samples.</param>
    /// <param name="scene">The scene, rendered by an integrator with <see cref="IntegratorTraits.Layers"/>.</param>
    /// <param name="kinds">Which; memory is taken for no others.</param>
    /// <exception cref="ArgumentException">The integrator has no light to split, or there are more than <see cref="MostLights"/> names of
    /// lights.</exception>
    public LightPathAovFilm(Film film, Scene scene, IEnumerable<LightPathAov> kinds)
    {
        _film = film;
        Groups = new(scene);
        (_place, Names) = Places(scene, Groups, kinds);
        long[][] Sums() => [.. Names.Select(_ => new long[checked(3L * film.Width * film.Height)])];
        (_pass, _sums, _upper) = (Sums(), Sums(), new int[]?[Names.Count]);
    }

    /// <summary>The names of the layers that a scene's film would have.</summary>
    /// <inheritdoc cref="LightPathAovFilm(Film, Scene, IEnumerable{LightPathAov})"/>
    public static IReadOnlyList<string> NamesOf(Scene scene, IEnumerable<LightPathAov> kinds) => Places(scene, new(scene), kinds).Names;

    /// <summary>The beginning of the names of layers of <see cref="LightPathAov.Lights"/>.</summary>
    public const string LightPrefix = "light.";

    /// <summary>The names of the layers.</summary>
    public IReadOnlyList<string> Names { get; }

    /// <summary>Number of the first layer of a light among all that a scene has.</summary>
    internal const int FirstLight = (int)LightPathAov.Lights;

    /// <summary>The scene's groups of lights.</summary>
    internal LightGroups Groups { get; }

    /// <summary>Memory in bytes of layers of a size.</summary>
    public static long Bytes(IReadOnlyCollection<LightPathAov> kinds, Scene scene)
    {
        int count = kinds.Distinct().Sum(k => k == LightPathAov.Lights ? new LightGroups(scene).Names.Count : 1);
        return 3L * 16 * count * scene.Render.Width * scene.Render.Height;
    }

    /// <summary>
    /// The name of the layer of a light, or of a group of lights, as the scene calls it: names of layers have no letters but ASCII's,
    /// digits, - and _.
    /// </summary>
    public static string NameOf(string light) => LightPrefix + LightGroupLabel.Plain(light);

    /// <summary>A layer as an image.</summary>
    /// <param name="layer">Its place among <see cref="Names"/>.</param>
    public IImageRows Image(int layer) => new Rows(this, layer);

    private static (int[] Places, IReadOnlyList<string> Names) Places(Scene scene, LightGroups groups, IEnumerable<LightPathAov> kinds)
    {
        if (!scene.Render.Integrator.Has(IntegratorTraits.Layers))
        {
            throw new ArgumentException(
                $"Layers of light: {Integrator.Only(IntegratorTraits.Layers, "write")} them, and the scene's is {scene.Render.Integrator}.", nameof(scene));
        }

        HashSet<LightPathAov> wanted = [.. kinds];
        if (wanted.Contains(LightPathAov.Lights) && groups.Names.Count > MostLights)
        {
            throw new ArgumentException($"The scene has {groups.Names.Count} names of lights, but there can be at most {MostLights} layers of them.", nameof(scene));
        }

        List<string> names = [];
        int[] places = new int[FirstLight + groups.Names.Count];
        for (int i = 0; i < places.Length; i++)
        {
            bool isKept = wanted.Contains(i < FirstLight ? (LightPathAov)i : LightPathAov.Lights);
            places[i] = isKept ? names.Count : -1;
            if (isKept)
            {
                names.Add(i < FirstLight ? ((LightPathAov)i).ToString().ToLowerInvariant() : $"{LightPrefix}{groups.Names[i - FirstLight]}");
            }
        }

        return (places, names);
    }

    /// <summary>Takes all light away.</summary>
    internal void Clear()
    {
        Array.ForEach(_pass, Array.Clear);
        Array.ForEach(_sums, Array.Clear);
        Array.Clear(_upper);
    }

    /// <summary>Begins a pass over a tile: what it has so far will not be taken back.</summary>
    internal void Begin(in Tile tile)
    {
        for (int layer = 0; layer < _sums.Length; layer++)
        {
            for (int y = tile.Y; y < tile.Y + tile.Height; y++)
            {
                Settle(layer, (((long)y * _film.Width) + tile.X) * 3, tile.Width * 3);
            }
        }
    }

    /// <summary>Takes back what the latest pass gave to a tile.</summary>
    internal void TakeBack(in Tile tile)
    {
        foreach (long[] pass in _pass)
        {
            for (int y = tile.Y; y < tile.Y + tile.Height; y++)
            {
                Array.Clear(pass, ((y * _film.Width) + tile.X) * 3, tile.Width * 3);
            }
        }
    }

    /// <summary>Adds what a sample of a pixel has of a layer, in the film's units.</summary>
    /// <param name="layer">The layer's number among all that the scene has.</param>
    /// <param name="pixel">The pixel's number.</param>
    /// <param name="channel">The channel.</param>
    /// <param name="units">The amount.</param>
    internal void Add(int layer, long pixel, int channel, long units)
    {
        if (_place[layer] >= 0)
        {
            _pass[_place[layer]][(3 * pixel) + channel] += units;
        }
    }

    /// <summary>All that is stored of a layer, for comparison.</summary>
    internal byte[] Content(int layer) =>
        MemoryMarshal.AsBytes<Int128>(Enumerable.Range(0, _sums[layer].Length).Select(i => Sum(layer, i)).ToArray()).ToArray();

    /// <summary>A sum of a layer, in the film's units.</summary>
    internal Int128 Sum(int layer, int x, int y, int channel) => Sum(layer, (3L * (((long)y * _film.Width) + x)) + channel);

    private Int128 Sum(int layer, long place) =>
        ((Int128)(_upper[layer]?[place] ?? 0) << 64) + _sums[layer][place] + _pass[layer][place];

    private void Settle(int layer, long first, int count)
    {
        (long[] sums, long[] pass) = (_sums[layer], _pass[layer]);
        for (long i = first; i < first + count; i++)
        {
            long sum = sums[i] + pass[i];
            if (((sum ^ sums[i]) & (sum ^ pass[i])) < 0)
            {
                // Both have the sign that the sum should have.
                Upper(layer)[i] += pass[i] < 0 ? -1 : 1;
            }

            (sums[i], pass[i]) = (sum, 0);
        }
    }

    // Several threads may be the first.
    private int[] Upper(int layer)
    {
        if (_upper[layer] is null)
        {
            Interlocked.CompareExchange(ref _upper[layer], new int[_sums[layer].LongLength], null);
        }

        return _upper[layer]!;
    }

    private sealed class Rows(LightPathAovFilm layers, int layer) : IImageRows
    {
        public int Width => layers._film.Width;

        public int Height => layers._film.Height;

        public void ReadRow(int y, Span<float> rgb)
        {
            for (int x = 0; x < Width; x++)
            {
                uint count = layers._film.SampleCount(x, y);
                double scale = count == 0 ? 0 : 1 / (Film.ChannelUnits * count);
                for (int channel = 0; channel < 3; channel++)
                {
                    rgb[(3 * x) + channel] = (float)((double)layers.Sum(layer, x, y, channel) * scale);
                }
            }
        }
    }
}
