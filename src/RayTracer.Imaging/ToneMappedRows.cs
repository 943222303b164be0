using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>An image seen through an exposure and a tone map; nothing is stored, each row is mapped when it is read.</summary>
public sealed class ToneMappedRows : IImageRows
{
    private readonly IImageRows _source;
    private readonly ToneMap _map;
    private readonly float _factor;

    /// <summary>Sets the image and how it is seen.</summary>
    /// <param name="source">Linear light.</param>
    /// <param name="map">The curve, applied after the exposure.</param>
    /// <param name="exposureStops">
    /// Exposure in stops, −100 to 100: light is multiplied by 2 to this power (exactly, for whole stops).
    /// </param>
    /// <exception cref="ArgumentOutOfRangeException">An exposure that is outside its range or NaN, or an undefined curve.</exception>
    public ToneMappedRows(IImageRows source, ToneMap map, float exposureStops)
    {
        if (!(exposureStops is >= -Exposure.Limit and <= Exposure.Limit))
        {
            throw new ArgumentOutOfRangeException(nameof(exposureStops), $"The exposure must be between -100 and 100 stops, not {exposureStops}.");
        }

        if (!Enum.IsDefined(map))
        {
            throw new ArgumentOutOfRangeException(nameof(map), $"There is no tone map {map}.");
        }

        _source = source;
        _map = map;
        _factor = (float)PortableMath.Exp2(exposureStops);
    }

    /// <inheritdoc/>
    public int Width => _source.Width;

    /// <inheritdoc/>
    public int Height => _source.Height;

    /// <inheritdoc/>
    public void ReadRow(int y, Span<float> rgb)
    {
        _source.ReadRow(y, rgb);
        for (int i = 0; i < 3 * Width; i += 3)
        {
            Rgb mapped = ToneMapping.Apply(_map, new Rgb(rgb[i], rgb[i + 1], rgb[i + 2]) * _factor);
            rgb[i] = mapped.R;
            rgb[i + 1] = mapped.G;
            rgb[i + 2] = mapped.B;
        }
    }
}
