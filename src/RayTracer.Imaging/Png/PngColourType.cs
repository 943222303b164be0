namespace RayTracer.Imaging;

/// <summary>The components of a PNG pixel, with the specification's numbers.</summary>
internal enum PngColourType
{
    Grey = 0,
    Rgb = 2,
    Palette = 3,
    GreyAlpha = 4,
    RgbAlpha = 6,
}
