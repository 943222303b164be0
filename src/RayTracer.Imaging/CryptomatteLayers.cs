using System.Buffers;
using System.Globalization;
using System.Text;
using System.Text.Json;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// Cryptomattes as layers and texts of OpenEXR files (Psyop's Cryptomatte specification 1.2): CryptoObject00 holds the two things that cover most of a pixel, as the number
/// of the first and the part that it covers in R and G, and those of the second in B and A; CryptoObject01 the next two; and a text the numbers of all names.
/// </summary>
public static class CryptomatteLayers
{
    private const string Letters = "RGBA";

    /// <summary>The layers of a Cryptomatte.</summary>
    public static IReadOnlyList<ExrLayerChannel> Of(AovFilm film, CryptomatteImage image) =>
    [
        .. Enumerable.Range(0, 2 * CryptomatteImage.Ranks).Select(channel => new ExrLayerChannel($"{image.Layer}{channel / 4:00}.{Letters[channel % 4]}", ExrPixelType.Float, (y, values) =>
        {
            for (int x = 0; x < film.Width; x++)
            {
                (uint id, double part) = film.Covering(image, x, y).ElementAtOrDefault(channel / 2);
                values.Span[x] = channel % 2 == 0 ? BitConverter.UInt32BitsToSingle(id) : part;
            }
        })),
    ];

    /// <summary>The texts that say what the layers mean.</summary>
    public static IReadOnlyList<KeyValuePair<string, string>> Texts(AovFilm film) => [.. film.Images.OfType<CryptomatteImage>().SelectMany(image => Texts(film, image))];

    private static IEnumerable<KeyValuePair<string, string>> Texts(AovFilm film, CryptomatteImage image)
    {
        string prefix = $"cryptomatte/{MatteNames.MurmurHash(Encoding.UTF8.GetBytes(image.Layer)).ToString("x8", CultureInfo.InvariantCulture)[..7]}/";
        yield return new(prefix + "name", image.Layer);
        yield return new(prefix + "hash", "MurmurHash3_32");
        yield return new(prefix + "conversion", "uint32_to_float32");
        yield return new(prefix + "manifest", Manifest(film.Shown(image)));
    }

    private static string Manifest(IEnumerable<(string Name, uint Id)> names)
    {
        ArrayBufferWriter<byte> text = new();
        using (Utf8JsonWriter json = new(text))
        {
            json.WriteStartObject();
            foreach ((string name, uint id) in names.OrderBy(n => n.Name, StringComparer.Ordinal))
            {
                json.WriteString(name, id.ToString("x8", CultureInfo.InvariantCulture));
            }

            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(text.WrittenSpan);
    }
}
