using RayTracer.Textbook;

namespace RayTracer.Adapters;

/// <summary>
/// The random numbers of a path's vertex, for a class that takes as many as it likes: the first single one and the first pair are those that the
/// sampler of the scene has spread evenly, and all others follow from their bits.
/// </summary>
/// <param name="u">The first number of the pair.</param>
/// <param name="v">The second number of the pair.</param>
/// <param name="choice">The single number.</param>
internal sealed class LaneSampler(float u, float v, float choice) : ISampler
{
    private readonly IndependentSampler _more = new(((long)BitConverter.SingleToUInt32Bits(u) << 32) | BitConverter.SingleToUInt32Bits(v));
    private bool _hasSingle = true;
    private bool _hasPair = true;
    private bool _hasBegun;

    /// <inheritdoc/>
    public void Begin(int x, int y, int sample) => throw new NotSupportedException("a material takes the numbers of the vertex that it is at");

    /// <inheritdoc/>
    public double Next()
    {
        if (_hasSingle)
        {
            _hasSingle = false;
            return choice;
        }

        return More().Next();
    }

    /// <inheritdoc/>
    public (double U, double V) Next2()
    {
        if (_hasPair)
        {
            _hasPair = false;
            return (u, v);
        }

        return More().Next2();
    }

    private IndependentSampler More()
    {
        if (!_hasBegun)
        {
            _more.Begin(BitConverter.SingleToInt32Bits(choice), 0, 0);
            _hasBegun = true;
        }

        return _more;
    }
}
