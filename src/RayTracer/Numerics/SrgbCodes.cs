namespace RayTracer.Numerics;

/// <summary>The sRGB curve tabulated for codes 0 … max.</summary>
internal sealed class SrgbCodes
{
    // A bucket holds the floats of one part in 2^12 of an octave. The first threshold of 16-bit codes is above 2^-21.
    private const int BucketShift = 23 - 12;
    private const int LowestBits = (127 - 21) << 23;
    private const int OneBits = 127 << 23;

    private readonly float[] _thresholds;
    private readonly ushort[] _firstCode;
    private readonly int _max;

    public SrgbCodes(int max)
    {
        _max = max;
        Linear = new float[max + 1];
        _thresholds = new float[max];
        for (int code = 0; code <= max; code++)
        {
            Linear[code] = (float)SrgbCurve.Decode(code / (double)max);
        }

        for (int code = 0; code < max; code++)
        {
            _thresholds[code] = AtLeast(SrgbCurve.Decode((code + 0.5) / max));
        }

        _firstCode = new ushort[(OneBits - LowestBits) >> BucketShift];
        int first = 0;
        for (int bucket = 0; bucket < _firstCode.Length; bucket++)
        {
            float lowest = BitConverter.Int32BitsToSingle(LowestBits + (bucket << BucketShift));
            first = Climb(first, lowest);
            _firstCode[bucket] = (ushort)first;
        }
    }

    /// <summary>Linear light of each code.</summary>
    public float[] Linear { get; }

    /// <summary>The code whose display value is nearest to that of <paramref name="linear"/>.</summary>
    public int Encode(float linear)
    {
        if (linear >= 1)
        {
            return _max;
        }

        int bits = BitConverter.SingleToInt32Bits(linear);
        if (!(linear > 0) || bits < LowestBits)
        {
            return 0;
        }

        return Climb(_firstCode[(bits - LowestBits) >> BucketShift], linear);
    }

    private static float AtLeast(double threshold)
    {
        float nearest = (float)threshold;
        return nearest < threshold ? float.BitIncrement(nearest) : nearest;
    }

    private int Climb(int code, float linear)
    {
        while (code < _max && _thresholds[code] <= linear)
        {
            code++;
        }

        return code;
    }
}
