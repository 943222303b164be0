using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>
/// Samples of some pixels of each block of a picture, which decide how many samples the block gets, and are never shown. They come from a
/// film of their own, with random numbers of their own: the picture knows nothing of them but a number, so its expectation is what it would be
/// with any other number (Kirk &amp; Arvo 1991, section 4, for why samples that decide must not be shown).
/// </summary>
internal sealed class DecidingSamples
{
    // Any number: it only has to make the seed another one.
    private const uint SeedChange = 0x6A09E667u;
    private readonly int[] _pixels;
    private readonly int[] _firstOfBlock;
    private readonly Film _film;
    private readonly Rgb[] _before;
    private readonly int[] _levels;
    private readonly uint _seed;

    /// <summary>Chooses the pixels: one of each cell, at random.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="blocks">The blocks.</param>
    /// <param name="cell">Edge of a cell in pixels.</param>
    public DecidingSamples(Scene scene, Tile[] blocks, int cell)
    {
        _seed = Hash.Mix((uint)scene.Render.Seed ^ SeedChange);
        List<int> pixels = [];
        _firstOfBlock = new int[blocks.Length + 1];
        for (int i = 0; i < blocks.Length; i++)
        {
            foreach (Tile part in Tile.Cut(blocks[i], cell))
            {
                int number = (part.Y * scene.Render.Width) + part.X;
                (int x, int y) = part.Pixel((int)(Hash.Mix((uint)number ^ _seed) % (uint)part.Pixels));
                pixels.Add((y * scene.Render.Width) + x);
            }

            _firstOfBlock[i + 1] = pixels.Count;
        }

        _pixels = [.. pixels];
        _film = new(_pixels.Length, 1);
        _before = new Rgb[_pixels.Length];
        _levels = new int[blocks.Length];
    }

    /// <summary>Samples of all deciding pixels so far.</summary>
    public long Total => _film.TotalSamples;

    /// <summary>Samples of each deciding pixel of a block so far.</summary>
    public int Level(int block) => _levels[block];

    /// <summary>Renders more samples.</summary>
    /// <param name="renderer">Renders them.</param>
    /// <param name="blocks">Of which blocks; all of them have the same number so far.</param>
    /// <param name="level">How many samples of each deciding pixel there shall be.</param>
    /// <param name="report">Told how many more paths and rays are done.</param>
    /// <param name="cancellation">Ends the work with an <see cref="OperationCanceledException"/>.</param>
    public void Advance(PixelRenderer renderer, int[] blocks, int level, Action<long, long> report, CancellationToken cancellation)
    {
        int[] targets = [.. blocks.SelectMany(b => Enumerable.Range(_firstOfBlock[b], _firstOfBlock[b + 1] - _firstOfBlock[b]))];
        foreach (int target in targets)
        {
            _before[target] = _film.Mean(target, 0);
        }

        renderer.Render(_film, [.. targets.Select(t => _pixels[t])], targets, new(_levels[blocks[0]], level), _seed, report, cancellation);
        foreach (int block in blocks)
        {
            _levels[block] = level;
        }
    }

    /// <summary>
    /// What the deciding samples tell of a block whose samples have doubled last: its brightness, and the variance of one sample, as if samples were
    /// independent. The mean of a half differs from the mean of both by as much as that does from the truth, on average, for independent
    /// samples; by more where samples are stratified (Dammertz et al. 2010 compare halves so, block by block).
    /// </summary>
    public (double Brightness, double Variance) Estimate(int block)
    {
        (double light, double squares) = (0, 0);
        for (int i = _firstOfBlock[block]; i < _firstOfBlock[block + 1]; i++)
        {
            Rgb mean = _film.Mean(i, 0);
            Rgb change = new(mean.R - _before[i].R, mean.G - _before[i].G, mean.B - _before[i].B);
            light += ((double)mean.R + mean.G + mean.B) / 3;
            squares += (((double)change.R * change.R) + ((double)change.G * change.G) + ((double)change.B * change.B)) / 3;
        }

        int pixels = _firstOfBlock[block + 1] - _firstOfBlock[block];
        return (light / pixels, squares / pixels * _levels[block]);
    }
}
