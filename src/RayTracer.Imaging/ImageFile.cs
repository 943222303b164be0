using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Picture files of every format that is known: PNG, JPEG, PFM, OpenEXR and Radiance HDR; and films, which are read only.</summary>
public static class ImageFile
{
    private const string Formats = "PNG, JPEG, PFM, OpenEXR and Radiance HDR";
    private static readonly string[] Extensions = [".png", ".jpg", ".jpeg", ".pfm", ".exr", ".hdr"];

    /// <summary>Reads a picture file; its format is told by its first bytes, not by its name.</summary>
    /// <param name="path">The file, of at most 2 GiB.</param>
    /// <param name="raw">Whether a PNG's or JPEG's values are data (0 to 1) rather than sRGB-encoded colours. PFM and OpenEXR are linear in any case.</param>
    /// <returns>Linear RGB.</returns>
    /// <exception cref="PictureException">The file is missing, of no known format, damaged or too large; the message names it.</exception>
    public static Picture Read(string path, bool raw = false) => OfFile(path, file => Decode(file, raw));

    /// <summary>Reads a picture file that is in memory; its format is told by its first bytes.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="raw">Whether a PNG's or JPEG's values are data (0 to 1) rather than sRGB-encoded colours.</param>
    /// <returns>Linear RGB.</returns>
    /// <exception cref="PictureException">The file is of no known format, damaged or too large; the message is a clause to follow the file's name and a colon.</exception>
    public static Picture Decode(ReadOnlySpan<byte> file, bool raw = false)
    {
        if (file.StartsWith(PngReader.Signature))
        {
            return PngReader.Read(file, raw);
        }

        if (file.StartsWith(JpegReader.Signature))
        {
            return JpegReader.Read(file, raw);
        }

        if (file.StartsWith(ExrReader.Signature))
        {
            return ExrReader.Read(file);
        }

        if (file.StartsWith(HdrReader.Signature))
        {
            return HdrReader.Read(file);
        }

        if (file.StartsWith(FilmFile.Signature))
        {
            return Picture(file);
        }

        return PfmReader.IsPfm(file) ? PfmReader.Read(file) : throw Unknown();
    }

    /// <summary>Reads how opaque the pixels of a picture file in memory are.</summary>
    /// <param name="file">The whole file.</param>
    /// <returns>0 to 1 in all three channels; null where the file does not say, as only PNG files with a channel for it do.</returns>
    /// <exception cref="PictureException">As for <see cref="Decode"/>.</exception>
    public static Picture? DecodeAlpha(ReadOnlySpan<byte> file) => file.StartsWith(PngReader.Signature) ? PngReader.ReadAlpha(file) : null;

    private static Picture Picture(ReadOnlySpan<byte> file)
    {
        using MemoryStream stream = new(file.ToArray(), writable: false);
        Rendering.Film film = FilmFile.Read(stream).Film;
        float[] pixels = new float[checked(3L * film.Width * film.Height)];
        for (int y = 0; y < film.Height; y++)
        {
            film.ReadRow(y, pixels.AsSpan(3 * film.Width * y, 3 * film.Width));
        }

        return new(film.Width, film.Height, pixels);
    }

    /// <summary>Reads all that a picture file holds, in one go: it may be a pipe.</summary>
    /// <param name="path">The file.</param>
    /// <returns>The picture; its texts, as <see cref="ReadText"/> has them; and of an OpenEXR file the channels that are not of the picture.</returns>
    /// <exception cref="PictureException">As for <see cref="Read"/>.</exception>
    public static (Picture Picture, IReadOnlyList<KeyValuePair<string, string>> Texts, IReadOnlyList<ExrLayerChannel> Layers) ReadAll(string path) =>
        OfFile(path, file => (Decode(file), TextOf(file), file.AsSpan().StartsWith(ExrReader.Signature) ? ExrReader.ReadLayers(file) : []));

    /// <summary>Whether a file is there and its first bytes are those of a picture or film.</summary>
    /// <param name="path">The file.</param>
    public static bool IsImage(string path) => FormatOf(path) is not null;

    /// <summary>The format that the first bytes of a file are those of, with the article: "a PNG picture", or "a film"; null for any other file, or none.</summary>
    /// <param name="path">The file.</param>
    public static string? FormatOf(string path)
    {
        try
        {
            // Who looks into a pipe, whose length is 0, takes from it.
            FileInfo file = new(path);
            if ((file.LinkTarget is null ? file : file.ResolveLinkTarget(returnFinalTarget: true)) is not FileInfo { Exists: true, Length: > 0 })
            {
                return null;
            }

            using FileStream stream = new(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 1);
            Span<byte> bytes = stackalloc byte[16];
            ReadOnlySpan<byte> head = bytes[..stream.ReadAtLeast(bytes, bytes.Length, throwOnEndOfStream: false)];
            return head.StartsWith(PngReader.Signature) ? "a PNG picture"
                : head.StartsWith(JpegReader.Signature) ? "a JPEG picture"
                : head.StartsWith(ExrReader.Signature) ? "an OpenEXR picture"
                : head.StartsWith(HdrReader.Signature) ? "a Radiance HDR picture"
                : head.StartsWith(FilmFile.Signature) ? FilmFormat
                : PfmReader.IsPfm(head) ? "a PFM picture" : null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            return null;
        }
    }

    /// <summary>What <see cref="FormatOf"/> calls a film.</summary>
    public const string FilmFormat = "a film";

    /// <summary>Reads what a picture file says of itself, without its pixels.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="PictureException">As for <see cref="Read"/>; a film is none.</exception>
    public static ImageDescription Describe(string path) => OfFile(path, file => Describe(file) with { FileBytes = file.Length });

    /// <summary>Reads what a picture file in memory says of itself, without its pixels.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">As for <see cref="Decode"/>; a film is none.</exception>
    public static ImageDescription Describe(ReadOnlySpan<byte> file) =>
        file.StartsWith(PngReader.Signature) ? PngReader.Describe(file)
        : file.StartsWith(JpegReader.Signature) ? JpegReader.Describe(file)
        : file.StartsWith(ExrReader.Signature) ? ExrReader.Describe(file)
        : file.StartsWith(HdrReader.Signature) ? HdrReader.Describe(file)
        : PfmReader.IsPfm(file) ? PfmReader.Describe(file) : throw Unknown();

    /// <summary>Reads the texts that a picture file carries, in their order; of a PFM, none. Comments of a JPEG that name no key are called "Comment".</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="PictureException">As for <see cref="Read"/>.</exception>
    public static IReadOnlyList<KeyValuePair<string, string>> ReadText(string path) => OfFile(path, TextOf);

    private static IReadOnlyList<KeyValuePair<string, string>> TextOf(byte[] file) =>
        file.StartsWith(PngReader.Signature) ? PngReader.ReadText(file)
        : file.StartsWith(ExrReader.Signature) ? ExrReader.ReadText(file)
        : file.StartsWith(JpegReader.Signature) ? JpegReader.ReadText(file)
        : file.StartsWith(HdrReader.Signature) ? HdrReader.ReadText(file)
        : PfmReader.IsPfm(file) || file.StartsWith(FilmFile.Signature) ? []
        : throw Unknown();

    /// <summary>
    /// Writes an image, row by row, in the format that the extension names (.png, .jpg, .jpeg, .pfm, .exr or .hdr). The file is there whole or not at
    /// all (<see cref="AtomicFile"/>).
    /// </summary>
    /// <param name="path">Where to; the folder must exist.</param>
    /// <param name="image">Linear RGB.</param>
    /// <param name="options">Details; by default 8 bits, JPEG of quality 90, no tone map, OpenEXR of halves with ZIP, no metadata.</param>
    /// <exception cref="ImageWriteException">The extension is unknown, the options cannot be met, or the file cannot be written.</exception>
    public static void Write(string path, IImageRows image, ImageWriteOptions? options = null)
    {
        string extension = KnownExtension(path);
        options ??= new ImageWriteOptions();
        try
        {
            AtomicFile.Write(path, stream => Encode(stream, extension, image, options));
        }
        catch (ArgumentException e)
        {
            string message = e.Message.Split(" (Parameter '")[0];
            throw new ImageWriteException($"Cannot write '{path}': {message}", e);
        }
    }

    /// <summary>Writes an image to memory, in the format that an extension names.</summary>
    /// <param name="extension">.png, .jpg, .jpeg, .pfm, .exr or .hdr.</param>
    /// <param name="image">Linear RGB.</param>
    /// <param name="options">As for <see cref="Write"/>.</param>
    /// <exception cref="ImageWriteException">The extension is unknown.</exception>
    public static byte[] Encode(string extension, IImageRows image, ImageWriteOptions options)
    {
        using MemoryStream stream = new();
        Encode(stream, KnownExtension($"picture{extension}"), image, options);
        return stream.ToArray();
    }

    /// <summary>Whether a file of this name holds colours to look at, encoded with the sRGB curve, rather than numbers: PNG and JPEG.</summary>
    public static bool IsForDisplay(string path) => Path.GetExtension(path).ToLowerInvariant() is ".png" or ".jpg" or ".jpeg";

    /// <summary>Tells at once, before a long computation, whether <see cref="Write"/> has a chance: the extension is known and the folder exists.</summary>
    /// <param name="path">Where an image is to be written.</param>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public static void Check(string path)
    {
        KnownExtension(path);
        AtomicFile.Check(path);
    }

    private static void Encode(Stream stream, string extension, IImageRows image, ImageWriteOptions options)
    {
        switch (extension)
        {
            case ".png":
                PngWriter.Write(stream, new ToneMappedRows(image, options.ToneMap, options.Exposure), options.BitDepth, options.Metadata);
                break;
            case ".jpg" or ".jpeg":
                JpegWriter.Write(stream, new ToneMappedRows(image, options.ToneMap, options.Exposure), options.JpegQuality, options.JpegChroma, options.Metadata);
                break;
            case ".pfm":
                PfmWriter.Write(stream, image);
                break;
            case ".hdr":
                HdrWriter.Write(stream, image, options.Metadata);
                break;
            default:
                ExrWriter.Write(stream, image, options.ExrPixelType, options.ExrCompression, options.Metadata, options.ExrLayers);
                break;
        }
    }

    /// <summary>The endings of names of files that are written, with their dots.</summary>
    public static IReadOnlyList<string> Written => Extensions;

    private const int LongestExtension = 16;

    private static string KnownExtension(string path)
    {
        string extension = Path.GetExtension(path).ToLowerInvariant();
        if (Extensions.Contains(extension))
        {
            return extension;
        }

        string has = extension.Length > 0 ? $"the extension '{extension}' is none of" : "its name has none of the extensions";
        string? nearest = extension.Length > LongestExtension ? null
            : Extensions.Where(known => EditDistance.Between(extension, known) <= 2).MinBy(known => EditDistance.Between(extension, known));
        string question = nearest is null ? "" : $" (did you mean '{nearest}'?)";
        throw new ImageWriteException($"Cannot write '{path}': {has} {string.Join(", ", Extensions)}{question}.");
    }

    private static PictureException Unknown() => new($"its first bytes are those of no picture format that is read ({Formats})");

    /// <summary>Reads something from a file, or from its beginning.</summary>
    /// <param name="path">The file.</param>
    /// <param name="read">Reads it.</param>
    /// <param name="what">What messages call it.</param>
    /// <param name="atMost">How many bytes to take of it.</param>
    /// <exception cref="PictureException">It cannot be read; the message names it.</exception>
    internal static T OfFile<T>(string path, Func<byte[], T> read, string what = "picture", int? atMost = null)
    {
        try
        {
            return read(Content(path, atMost));
        }
        catch (PictureException e)
        {
            throw new PictureException($"Cannot read the {what} '{path}': {e.Message}.", e);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new PictureException($"Cannot read the {what} '{path}': {Reason(e)}.", e);
        }
    }

    /// <summary>The bytes of a file, or the first ones.</summary>
    internal static byte[] Content(string path, int? atMost = null)
    {
        using var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 1);
        if (!stream.CanSeek)
        {
            using MemoryStream all = new();
            stream.CopyTo(all);
            return all.ToArray();
        }

        if (stream.Length > Array.MaxLength && atMost is null)
        {
            throw new PictureException($"it has {stream.Length} bytes, more than 2 GiB");
        }

        var content = new byte[Math.Min(stream.Length, atMost ?? Array.MaxLength)];
        stream.ReadExactly(content);
        return content;
    }

    private static string Reason(Exception e) => e switch
    {
        FileNotFoundException or DirectoryNotFoundException => "there is no such file",
        UnauthorizedAccessException => "it is a folder, or access to it is denied",
        _ => e.Message.ReplaceLineEndings(" ").TrimEnd('.'),
    };
}
