namespace RayTracer.Imaging;

/// <summary>A channel of an OpenEXR file: it has a value where x and y are multiples of the steps.</summary>
internal readonly record struct ExrChannel(string Name, ExrPixelType Type, int StepX, int StepY)
{
    /// <summary>Bytes of one value.</summary>
    public int ValueBytes => Type == ExrPixelType.Half ? 2 : 4;

    /// <summary>Bytes of the channel's part of row y, for columns first … last.</summary>
    public long RowBytes(int y, int first, int last)
    {
        if (y % StepY != 0)
        {
            return 0;
        }

        long multiples = FloorDivide(last, StepX) - FloorDivide((long)first - 1, StepX);
        return multiples * ValueBytes;
    }

    private static long FloorDivide(long a, int b) => a >= 0 ? a / b : -((-a + b - 1) / b);
}
