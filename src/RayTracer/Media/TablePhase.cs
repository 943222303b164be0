using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>A phase function that is measured or computed elsewhere: numbers at cosines that are evenly spaced from −1 to 1, and linear between them.</summary>
internal sealed unsafe class TablePhase : PhaseFunction
{
    // No density of what was chosen is 0.
    private const float Least = 1e-30f;
    private readonly PinnedBuffer<float> _densities;
    private readonly PinnedBuffer<float> _sums;
    private readonly int _intervals;
    private readonly uint _half;

    /// <summary>Makes the phase function.</summary>
    /// <param name="values">Two numbers or more, at least 0, and not all 0; a factor on all of them has no effect.</param>
    public TablePhase(IReadOnlyList<float> values)
    {
        _intervals = values.Count - 1;
        double area = 0;
        for (int i = 0; i < _intervals; i++)
        {
            area += ((double)values[i] + values[i + 1]) / _intervals;
        }

        // As many sums as a search by halves asks for: those behind the last interval are above all random numbers.
        uint room = BitOperations.RoundUpToPowerOf2((uint)_intervals);
        _half = room / 2;
        _densities = new(values.Count);
        _sums = new(room);
        new Span<float>(_sums.Pointer, (int)room).Fill(2);
        double sum = 0;
        for (int i = 0; i <= _intervals; i++)
        {
            _densities.Pointer[i] = (float)(values[i] / area);
            if (i < _intervals)
            {
                _sums.Pointer[i] = (float)sum;
                sum += ((double)values[i] + values[i + 1]) / (_intervals * area);
            }
        }
    }

    /// <inheritdoc/>
    public override FloatW Evaluate(in Vec3W point, FloatW cosine)
    {
        FloatW at = FloatW.Max(0f, FloatW.Min((cosine + 1f) * (_intervals * 0.5f), _intervals));
        FloatW first = FloatW.Min(FloatW.Floor(at), _intervals - 1);
        Ends(first.ToIntInRange(), out FloatW low, out FloatW high);
        return FloatW.Max(FloatW.MultiplyAdd(high - low, at - first, low) * (1f / (2 * float.Pi)), Least);
    }

    /// <inheritdoc/>
    public override FloatW Cosine(in Vec3W point, FloatW choice, FloatW u)
    {
        UIntW interval = 0u;
        for (uint step = _half; step > 0; step /= 2)
        {
            interval = (FloatW.Gather(_sums.Pointer, interval + step) <= u).Select(interval + step, interval);
        }

        // Of a line from low to high, what lies under it up to a part of the interval is a quadratic; its root, without a difference of what may be alike.
        Ends(interval, out FloatW low, out FloatW high);
        FloatW rest = (u - FloatW.Gather(_sums.Pointer, interval)) * (_intervals * 0.5f);
        FloatW root = FloatW.Sqrt(FloatW.Max(FloatW.MultiplyAdd((high - low) * 2f, rest, low * low), 0f));
        FloatW part = FloatW.Min(rest * 2f / FloatW.Max(low + root, float.Epsilon), 1f);
        return FloatW.Min(FloatW.MultiplyAdd(interval.ToFloat() + part, 2f / _intervals, -1f), 1f);
    }

    private void Ends(UIntW interval, out FloatW low, out FloatW high) => FloatW.Gather(_densities.Pointer, interval, out low, out high);
}
