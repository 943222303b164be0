namespace RayTracer.Textbook;

/// <summary>The source of random numbers from 0 to 1 (never 1), each independent of the others.</summary>
public interface ISampler
{
    /// <summary>Begins with another sample of a pixel. The numbers that follow depend on these three alone.</summary>
    /// <param name="x">Column of the pixel.</param>
    /// <param name="y">Row of the pixel.</param>
    /// <param name="sample">Number of the sample, from 0.</param>
    void Begin(int x, int y, int sample);

    /// <summary>One number.</summary>
    double Next();

    /// <summary>Two numbers, which a sampler may spread evenly over the square.</summary>
    (double U, double V) Next2();
}

/// <summary>Numbers that know nothing of each other.</summary>
/// <param name="seed">Another seed gives other numbers.</param>
public sealed class IndependentSampler(long seed = 0) : ISampler
{
    private ulong _state;

    /// <inheritdoc/>
    public void Begin(int x, int y, int sample) =>
        _state = Hash(Hash(Hash((ulong)seed ^ 0x9E3779B97F4A7C15) + (ulong)sample) + (((ulong)(uint)x << 32) | (uint)y));

    /// <summary>SplitMix64: a counter, whose bits are mixed (Steele, Lea &amp; Flood 2014).</summary>
    public double Next()
    {
        _state += 0x9E3779B97F4A7C15;
        return (Hash(_state) >> 11) * (1.0 / (1UL << 53));
    }

    /// <inheritdoc/>
    public (double U, double V) Next2() => (Next(), Next());

    /// <summary>Mixes all bits of a number.</summary>
    internal static ulong Hash(ulong x)
    {
        x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
        x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
        return x ^ (x >> 31);
    }
}

/// <summary>
/// Jittered numbers (report, section 3.4): with n² samples, each pair lies in another one of n × n cells. Every pair visits the cells in an order
/// of its own, which a permutation gives without a table (Kensler, Correlated multi-jittered sampling, 2013).
/// </summary>
/// <param name="side">n; samples beyond n² begin again.</param>
/// <param name="seed">Another seed gives other numbers.</param>
public sealed class StratifiedSampler(int side, long seed = 0) : ISampler
{
    private readonly IndependentSampler _random = new(seed);
    private ulong _pixel;
    private uint _sample;
    private uint _dimension;

    /// <inheritdoc/>
    public void Begin(int x, int y, int sample)
    {
        _random.Begin(x, y, sample);
        uint cells = (uint)(side * side);
        (_sample, _dimension) = ((uint)sample % cells, 0);

        // Another round of cells is in another order.
        _pixel = IndependentSampler.Hash((((ulong)(uint)x << 32) | (uint)y) + IndependentSampler.Hash((ulong)seed + ((uint)sample / cells)));
    }

    /// <inheritdoc/>
    public double Next() => (Cell() + _random.Next()) / ((double)side * side);

    /// <inheritdoc/>
    public (double U, double V) Next2()
    {
        uint cell = Cell();
        return ((cell % (uint)side + _random.Next()) / side, (cell / (uint)side + _random.Next()) / side);
    }

    // The sample's place in the order of this dimension: mixing bits within the next power of two is a permutation of that many numbers; those
    // that fall outside are mixed again.
    private uint Cell()
    {
        uint count = (uint)(side * side);
        uint key = (uint)IndependentSampler.Hash(_pixel + (0x9E3779B97F4A7C15 * ++_dimension));
        uint mask = System.Numerics.BitOperations.RoundUpToPowerOf2(count) - 1;
        uint i = _sample;
        do
        {
            i = (i ^ key) & mask;
            i = (i * 0xE170893D) & mask;
            i ^= (key >> 16) & mask;
            i ^= (i & mask) >> 4;
            i = (i * (0x0929EB3F | 1)) & mask;
            i ^= (i & mask) >> 1;
            i = (i * (1 | (key >> 27))) & mask;
            i = (i * 0x6935FA69) & mask;
            i ^= (i & mask) >> 11;
            i = (i * 0x74DCB303) & mask;
            i ^= (i & mask) >> 2;
            i = (i * 0x9E501CC3) & mask;
        }
        while (i >= count);
        return (i + key) % count;
    }
}
