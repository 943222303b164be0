namespace RayTracer.Imaging;

/// <summary>A channel of an OpenEXR file: it has a value where x and y are multiples of the steps.</summary>
internal readonly record struct ExrChannel(string Name, ExrPixelType Type, bool IsPerceptual, int StepX, int StepY)
{
    /// <summary>Bytes of one value.</summary>
    public int ValueBytes => Type == ExrPixelType.Half ? 2 : 4;

    /// <summary>Bytes of the channel's part of a rectangle.</summary>
    public long Bytes(int top, int rows, int left, int columns) =>
        Multiples(left, columns, StepX) * Multiples(top, rows, StepY) * ValueBytes;

    private static long Multiples(int first, int count, int step) =>
        FloorDivide((long)first + count - 1, step) - FloorDivide((long)first - 1, step);

    private static long FloorDivide(long a, int b) => a >= 0 ? a / b : -((-a + b - 1) / b);
}
