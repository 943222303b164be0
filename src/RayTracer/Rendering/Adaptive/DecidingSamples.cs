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
    // As long as a sample of each pixel of a picture whose 4×4 pixels share a deciding one.
    private const int SamplesPerStep = 16;

    // Any number: it only has to make the seed another one.
    private const uint SeedChange = 0x6A09E667u;
    private readonly int[] _pixels;
    private readonly int[] _firstOfBlock;
    private readonly Film _film;
    private readonly Rgb[] _before;
    private readonly int[] _levels;
    private readonly uint _seed;
    private Film _filmBefore;
    private bool _isWithin;

    /// <summary>Chooses the pixels: one of each cell, at random.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="blocks">The blocks.</param>
    /// <param name="cell">Edge of a cell in pixels.</param>
    /// <param name="planes">The planes that are kept beside their colours: <see cref="FilmPlane.Light"/>, if the light of paths from the lights counts.</param>
    public DecidingSamples(Scene scene, Tile[] blocks, int cell, IReadOnlyList<FilmPlane> planes)
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
        _film = new(_pixels.Length, 1, planes);
        _filmBefore = new(_pixels.Length, 1, planes);
        _before = new Rgb[_pixels.Length];
        _levels = new int[blocks.Length];
    }

    /// <summary>Told how far it has come, now and then, where all blocks have the same number of samples; may be null.</summary>
    public Action<DecidingState>? Keep { get; init; }

    /// <summary>Samples of all deciding pixels so far.</summary>
    public long Total => _film.TotalSamples;

    /// <summary>Samples of each deciding pixel of a block so far.</summary>
    public int Level(int block) => _levels[block];

    /// <summary>Begins with what there was, in the middle of an <see cref="Advance"/>.</summary>
    /// <exception cref="ArgumentException">It is of another picture.</exception>
    public void Restore(DecidingState state)
    {
        if ((state.Film.Width, state.Film.Height) != (_pixels.Length, 2))
        {
            throw new ArgumentException($"There are {state.Film.Width} deciding pixels, not {_pixels.Length}.", nameof(state));
        }

        for (int i = 0; i < _before.Length; i++)
        {
            _before[i] = state.Film.Mean(i, 0);
        }

        AddRow(_film, 0, state.Film, 1);
        AddRow(_filmBefore, 0, state.Film, 0);
        Array.Fill(_levels, state.Samples);
        _isWithin = true;
    }

    /// <summary>Renders more samples.</summary>
    /// <param name="renderer">Renders them.</param>
    /// <param name="blocks">Of which blocks; all of them have the same number so far.</param>
    /// <param name="level">The number of samples that each deciding pixel shall have.</param>
    /// <param name="report">Told how many more paths and rays are done.</param>
    /// <param name="cancellation">Ends the work with an <see cref="OperationCanceledException"/>.</param>
    public void Advance(PixelRenderer renderer, int[] blocks, int level, Action<long, long> report, CancellationToken cancellation)
    {
        int[] targets = [.. blocks.SelectMany(b => Enumerable.Range(_firstOfBlock[b], _firstOfBlock[b + 1] - _firstOfBlock[b]))];
        int[] pixels = [.. targets.Select(t => _pixels[t])];
        Begin(targets);
        while (_levels[blocks[0]] is var first && first < level)
        {
            int end = Keep is null ? level : Math.Min(level, first + SamplesPerStep);
            renderer.Render(_film, pixels, targets, new(first, end), _seed, report, cancellation);
            foreach (int block in blocks)
            {
                _levels[block] = end;
            }

            Keep?.Invoke(new(State(), end, level));
        }
    }

    private void Begin(int[] targets)
    {
        if (_isWithin)
        {
            _isWithin = false;
            return;
        }

        foreach (int target in targets)
        {
            _before[target] = _film.Mean(target, 0);
        }

        if (Keep is not null)
        {
            _filmBefore = new(_pixels.Length, 1, _film.Planes);
            AddRow(_filmBefore, 0, _film, 0);
        }
    }

    private Film State()
    {
        Film state = new(_pixels.Length, 2, _film.Planes);
        AddRow(state, 0, _filmBefore, 0);
        AddRow(state, 1, _film, 0);
        return state;
    }

    private static void AddRow(Film target, int y, Film source, int row)
    {
        Int128[] sums = new Int128[target.Width * Film.SumsPerPixel];
        uint[] counts = new uint[target.Width];
        source.ReadSums(row, sums, counts);
        target.AddSums(y, sums, counts);
        foreach (FilmPlane plane in target.Planes)
        {
            Int128[] ofPlane = new Int128[target.Width * plane.Sums.Count];
            source.ReadPlane(plane, row, ofPlane);
            target.AddPlane(plane, y, ofPlane);
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
