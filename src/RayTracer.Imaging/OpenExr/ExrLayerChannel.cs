namespace RayTracer.Imaging;

/// <summary>A channel beside R, G and B in an OpenEXR file.</summary>
/// <param name="Name">
/// Its name, such as <c>depth.Z</c>: the layer, a point, and the channel of the layer; 1 to 255 bytes of ASCII without NUL.
/// </param>
/// <param name="Type">How its values are stored.</param>
/// <param name="ReadRow">Writes the values of a row (0 is the top), one a pixel.</param>
public sealed record ExrLayerChannel(string Name, ExrPixelType Type, Action<int, Memory<double>> ReadRow);
