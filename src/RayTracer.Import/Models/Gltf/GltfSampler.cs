using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Values between keys (glTF 2.0, section 3.11 and appendix C).</summary>
internal sealed class GltfSampler
{
    private readonly float[] _times;
    private readonly float[] _values;
    private readonly Interpolation _interpolation;

    /// <summary>Reads and checks the keys.</summary>
    /// <param name="accessors">The file's accessors.</param>
    /// <param name="sampler">The sampler in the file.</param>
    /// <param name="components">The number of numbers of an element of its values.</param>
    public GltfSampler(GltfAccessors accessors, GltfObject sampler, int components)
    {
        _times = accessors.Floats(sampler, "input", 1) ?? throw sampler.Missing("input");
        _values = accessors.Floats(sampler, "output", components) ?? throw sampler.Missing("output");
        _interpolation = sampler.Text("interpolation") switch
        {
            null or "LINEAR" => Interpolation.Linear,
            "STEP" => Interpolation.Step,
            "CUBICSPLINE" => Interpolation.Cubic,
            _ => throw sampler.Error("interpolation", "expected \"LINEAR\", \"STEP\" or \"CUBICSPLINE\""),
        };
        int elements = _times.Length * (IsCubic ? 3 : 1);
        Width = _values.Length / elements;
        if (Width == 0 || _values.Length != elements * Width || (components > 1 && Width != components))
        {
            throw sampler.Error("output", $"it has {_values.Length / components} elements, which does not go with {_times.Length} keys");
        }

        if (!(_times[0] >= 0) || !float.IsFinite(_times[^1]) || _times.Zip(_times.Skip(1)).Any(t => !(t.First < t.Second)) || !Array.TrueForAll(_values, float.IsFinite))
        {
            throw sampler.Error("the times of its keys must be 0 or more, each later than the one before, and all values finite");
        }
    }

    private enum Interpolation
    {
        Linear,
        Step,
        Cubic,
    }

    /// <summary>The number of numbers of a value.</summary>
    public int Width { get; }

    /// <summary>The times of the keys, in seconds.</summary>
    public IReadOnlyList<float> Times => _times;

    /// <summary>True where values between keys are not what is between them in proportion to time.</summary>
    public bool IsCurved => _interpolation != Interpolation.Linear;

    private bool IsCubic => _interpolation == Interpolation.Cubic;

    /// <summary>A rotation at a time.</summary>
    public Quaternion64 Rotation(double time)
    {
        if (_interpolation != Interpolation.Linear)
        {
            double[] q = At(time);
            return Unit(new(q[0], q[1], q[2], q[3]));
        }

        (int from, int to, double t) = Find(time);
        return Quaternion64.Slerp(Key(from), Key(to), t);
    }

    /// <summary>The value at a time: before the first key that of the first, after the last that of the last.</summary>
    public double[] At(double time)
    {
        (int from, int to, double t) = Find(time);
        double[] value = new double[Width];
        for (int i = 0; i < Width; i++)
        {
            value[i] = _interpolation switch
            {
                Interpolation.Step => Value(t < 1 ? from : to, i),
                Interpolation.Linear => Value(from, i) + (t * ((double)Value(to, i) - Value(from, i))),
                _ => Cubic(from, to, t, i),
            };
        }

        return value;
    }

    // Hermite's spline, with the tangents that keys have behind and before them (appendix C.5).
    private double Cubic(int from, int to, double t, int i)
    {
        double length = (double)_times[to] - _times[from];
        double leaving = _values[(((from * 3) + 2) * Width) + i] * length;
        double arriving = _values[(to * 3 * Width) + i] * length;
        double square = t * t;
        double cube = square * t;
        return (((2 * cube) - (3 * square) + 1) * Value(from, i)) + ((cube - (2 * square) + t) * leaving)
            + (((3 * square) - (2 * cube)) * Value(to, i)) + ((cube - square) * arriving);
    }

    private float Value(int key, int i) => _values[(((IsCubic ? (key * 3) + 1 : key)) * Width) + i];

    private Quaternion64 Key(int key) => Unit(new(Value(key, 0), Value(key, 1), Value(key, 2), Value(key, 3)));

    private static Quaternion64 Unit(Quaternion64 q) => q.Dot(q) > 0 ? q.Unit() : new(0, 0, 0, 1);

    // The keys around a time, and how far it is from one to the other.
    private (int From, int To, double T) Find(double time)
    {
        int next = 0;
        int end = _times.Length;
        while (next < end)
        {
            int middle = (next + end) / 2;
            (next, end) = _times[middle] <= time ? (middle + 1, end) : (next, middle);
        }

        (int from, int to) = (int.Max(next - 1, 0), int.Min(next, _times.Length - 1));
        return from == to || time <= _times[from] ? (from, to, 0) : (from, to, (time - _times[from]) / ((double)_times[to] - _times[from]));
    }
}
