using System.Security.Cryptography;
using System.Text;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// OpenEXR images that carry their film to the bit, so that samples can be added to it as to a <see cref="FilmFile"/>. Sums and numbers of
/// samples are channels of 32-bit unsigned integers, which none of the format's compressions changes. docs/long-renders.md describes them.
/// </summary>
public static class FilmExr
{
    /// <summary>
    /// The largest number of pixels that is written with the film, 2²⁵ (a picture of 8K): files of more than 2 GiB could not be read again.
    /// </summary>
    public const long MaxPixels = 1L << 25;

    private const string Extension = ".exr";
    private const string Layer = "film.";
    private const string Count = $"{Layer}count";
    private const string HeaderKey = "Film";
    private const string ChecksumKey = "FilmChecksum";
    private const string HashKey = "FilmHash";
    private const int WordsOf64Bits = 2;
    private const int WordsOf128Bits = 4;
    private const int LongestHead = 1 << 23;
    private static readonly string[] s_sums = ["red", "green", "blue", "square"];

    /// <summary>Returns whether a file's name is one of an OpenEXR image.</summary>
    public static bool IsNamed(string path) => path.EndsWith(Extension, StringComparison.OrdinalIgnoreCase);

    /// <summary>
    /// Returns whether a file is named as an OpenEXR image, and is one that carries its film; false also where there is no file, or a
    /// damaged one.
    /// </summary>
    public static bool Is(string path)
    {
        try
        {
            return IsNamed(path) && IsImage(path) && Head(path).Texts.Any(t => t.Key == HeaderKey);
        }
        catch (PictureException)
        {
            return false;
        }
    }

    /// <summary>Returns whether a file is there and begins as an OpenEXR image.</summary>
    internal static bool IsImage(string path)
    {
        try
        {
            // A pipe has no length, and must not be waited for.
            return new FileInfo(path) is { Exists: true, Length: > 0 } && ImageFile.Content(path, ExrReader.Signature.Length).AsSpan().SequenceEqual(ExrReader.Signature);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            return false;
        }
    }

    /// <summary>
    /// Writes a picture with its film. The file is there whole or not at all, and what was there before stays until then
    /// (<see cref="AtomicFile"/>).
    /// </summary>
    /// <param name="path">The file, whose name ends with .exr.</param>
    /// <param name="film">The film.</param>
    /// <param name="header">The header of the film.</param>
    /// <param name="options">Further texts and layers.</param>
    /// <exception cref="ImageWriteException">It cannot be written.</exception>
    public static void Write(string path, Film film, FilmHeader header, ImageWriteOptions options)
    {
        if ((long)film.Width * film.Height > MaxPixels)
        {
            throw new ImageWriteException($"Cannot write '{path}': {TooLarge}.");
        }

        string text = Encoding.UTF8.GetString((header with { Planes = film.KeptPlanes }).ToBytes());
        (IImageRows image, options) = TransparentRows.Of(film, film, options);
        ImageFile.Write(path, image, options with
        {
            Metadata = [.. options.Metadata.Where(t => t.Key != HashKey), new(HashKey, film.ComputeHash()), new(HeaderKey, text), new(ChecksumKey, Checksum(text))],
            ExrLayers = [.. options.ExrLayers, .. Channels(film)],
        });
    }

    /// <summary>The reason why larger pictures are refused, as a clause.</summary>
    public static string TooLarge => $"an OpenEXR image carries films of at most {MaxPixels} pixels; an .rtfilm file has no such limit";

    /// <summary>Reads what a file says about its film.</summary>
    /// <exception cref="PictureException">It cannot be read, is damaged, or carries no film.</exception>
    public static FilmHeader ReadHeader(string path) =>
        ImageFile.OfFile(path, file => HeaderOf(ExrHeader.Parse(file)), "film", LongestHead);

    /// <summary>Reads a film.</summary>
    /// <inheritdoc cref="ReadHeader"/>
    public static (FilmHeader Header, Film Film) Read(string path) => ImageFile.OfFile(path, file => Read(file), "film");

    /// <summary>Returns whether a channel is one of those that are the film.</summary>
    public static bool IsOfFilm(string channel) => channel.StartsWith(Layer, StringComparison.Ordinal);

    /// <summary>The names of a file's layers beside picture and film.</summary>
    /// <exception cref="PictureException">It cannot be read, or is damaged.</exception>
    public static IReadOnlyList<string> OtherLayers(string path) =>
        [.. Head(path).Channels.Select(c => c.Name).Where(n => n is not ("R" or "G" or "B" or ExrFormat.Alpha) && !IsOfFilm(n)).Select(n => n.Split('.')[0]).Distinct()];

    /// <summary>Reads a film from a whole file.</summary>
    /// <exception cref="PictureException">It is damaged, or carries no film; the message is a clause.</exception>
    internal static (FilmHeader Header, Film Film) Read(ReadOnlySpan<byte> file)
    {
        ExrHeader exr = ExrHeader.Parse(file);
        FilmHeader header = HeaderOf(exr).WithKnownPlanes();
        string[] names = SumsOf(header.Planes);
        int words = exr.Channels.Any(c => c.Name == Word(names[0], WordsOf128Bits - 1)) ? WordsOf128Bits : WordsOf64Bits;
        Film? film = null;
        Int128[][] parts = Parts(exr.Width, header.Planes);
        string[] channels = [Count, .. names.SelectMany(name => Enumerable.Range(0, words).Select(word => Word(name, word)))];
        ExrReader.ReadWords(file, exr, channels, (y, row) =>
        {
            int first = 1;
            foreach (Int128[] sums in parts)
            {
                int count = sums.Length / exr.Width;
                for (int i = 0; i < sums.Length; i++)
                {
                    sums[i] = Sum(row.AsSpan(first + (i % count * words), words), i / count);
                }

                first += count * words;
            }

            film ??= new(header.Width, header.Height, header.Planes);
            film.AddSums(y, parts[0], row[0]);
            for (int i = 0; i < header.Planes.Count; i++)
            {
                film.AddPlane(header.Planes[i], y, parts[1 + i]);
            }
        });
        return film!.ComputeHash() == TextOf(exr, HashKey) ? (header, film)
            : throw new PictureException($"the sums of its film are damaged: their hash is not the one in its text {HashKey}");
    }

    private static ExrHeader Head(string path) => ImageFile.OfFile(path, file => ExrHeader.Parse(file), "film", LongestHead);

    private static FilmHeader HeaderOf(ExrHeader exr)
    {
        string text = TextOf(exr, HeaderKey) ?? throw new PictureException("it is an image that does not carry its film: only those written with --exr-film do");
        if (TextOf(exr, ChecksumKey) != Checksum(text))
        {
            throw new PictureException($"its text {HeaderKey}, which describes its film, is damaged: its checksum does not match");
        }

        FilmHeader header = FilmHeader.Of(Encoding.UTF8.GetBytes(text));
        return (header.Width, header.Height) != (exr.Width, exr.Height) ? throw new PictureException($"its film has {header.Width}×{header.Height} pixels, but its picture {exr.Width}×{exr.Height}")
            : (long)header.Width * header.Height > MaxPixels ? throw new PictureException(TooLarge) : header;
    }

    private static string? TextOf(ExrHeader exr, string key) => exr.Texts.FirstOrDefault(t => t.Key == key).Value;

    private static string Checksum(string text) => Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(text)));

    // The name of the channel of 32 bits of a sum, the lowest ones first.
    private static string Word(string sum, int word) => $"{Layer}{sum}.{word}";

    // The names of all sums of a pixel.
    private static string[] SumsOf(IReadOnlyList<FilmPlane> planes) =>
        [.. s_sums, .. planes.SelectMany(p => p.Sums.Select(sum => $"{p}.{sum}"))];

    // Room for a row's sums: those of the picture, and of each plane.
    private static Int128[][] Parts(int width, IReadOnlyList<FilmPlane> planes) =>
        [new Int128[s_sums.Length * width], .. planes.Select(p => new Int128[p.Sums.Count * width])];

    private static Int128 Sum(ReadOnlySpan<uint[]> words, int x)
    {
        ulong low = words[0][x] | ((ulong)words[1][x] << 32);
        return words.Length == WordsOf64Bits ? unchecked((long)low) : new Int128(words[2][x] | ((ulong)words[3][x] << 32), low);
    }

    private static List<ExrLayerChannel> Channels(Film film)
    {
        IReadOnlyList<FilmPlane> planes = film.KeptPlanes;
        string[] names = SumsOf(planes);
        Int128[][] parts = Parts(film.Width, planes);
        uint[] counts = new uint[film.Width];
        int words = WordsOf64Bits;

        // The writer asks for one row's channels after another.
        int read = -1;
        void Read(int y)
        {
            film.ReadSums(y, parts[0], counts);
            for (int i = 0; i < planes.Count; i++)
            {
                film.ReadPlane(planes[i], y, parts[1 + i]);
            }

            read = y;
        }

        for (int y = 0; y < film.Height; y++)
        {
            Read(y);
            words = Array.Exists(parts, FilmFile.AreWide) ? WordsOf128Bits : words;
        }

        ExrLayerChannel Channel(string name, Func<int, uint> value) => new(name, ExrPixelType.Uint, (y, values) =>
        {
            if (read != y)
            {
                Read(y);
            }

            for (int x = 0; x < film.Width; x++)
            {
                values.Span[x] = value(x);
            }
        });

        List<ExrLayerChannel> channels = [Channel(Count, x => counts[x])];
        int named = 0;
        foreach (Int128[] sums in parts)
        {
            int count = sums.Length / film.Width;
            for (int i = 0; i < count * words; i++)
            {
                (int sum, int word) = (i / words, i % words);
                channels.Add(Channel(Word(names[named + sum], word), x => unchecked((uint)(sums[(count * x) + sum] >> (32 * word)))));
            }

            named += count;
        }

        return channels;
    }
}
