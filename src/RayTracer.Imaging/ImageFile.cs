using RayTracer.Description;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>Picture files of every <see cref="ImageFormat"/> that is known.</summary>
public static class ImageFile
{
    /// <summary>Reads a picture file; its format is recognized by its first bytes, not by its name.</summary>
    /// <param name="path">The file, of at most 2 GiB.</param>
    /// <param name="raw">
    /// Whether a PNG's or JPEG's values are data (0 to 1) rather than sRGB-encoded colours. PFM and OpenEXR are linear in any case.
    /// </param>
    /// <returns>Linear RGB.</returns>
    /// <exception cref="PictureException">The file is missing, of no known format, damaged or too large; the message names it.</exception>
    public static Picture Read(string path, bool raw = false) => OfInput(path, file => Decode(file, raw));

    /// <summary>Reads a picture file that is in memory; its format is recognized by its first bytes.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="raw">True where a PNG's or JPEG's values are data (0 to 1) rather than sRGB-encoded colours.</param>
    /// <returns>Linear RGB.</returns>
    /// <exception cref="PictureException">
    /// The file is of no known format, damaged or too large; the message is a clause to follow the file's name and a colon.
    /// </exception>
    public static Picture Decode(ReadOnlySpan<byte> file, bool raw = false) => Known(file).Read(file, raw);

    /// <summary>Reads how opaque the pixels of a picture file in memory are.</summary>
    /// <param name="file">The whole file.</param>
    /// <returns>0 to 1 in all three channels; null where the file does not say, as only PNG files with a channel for it do.</returns>
    /// <exception cref="PictureException">As for <see cref="Decode"/>.</exception>
    public static Picture? DecodeAlpha(ReadOnlySpan<byte> file) => ImageFormat.Of(file)?.ReadAlpha(file);

    /// <summary>Reads all that a picture file holds, in one go: it may be a pipe.</summary>
    /// <param name="path">The file.</param>
    /// <returns>
    /// The picture; its texts, as <see cref="ReadText"/> has them; and of an OpenEXR file the channels that are not of the picture.
    /// </returns>
    /// <exception cref="PictureException">As for <see cref="Read"/>.</exception>
    public static (Picture Picture, IReadOnlyList<KeyValuePair<string, string>> Texts, IReadOnlyList<ExrLayerChannel> Layers) ReadAll(string path) =>
        OfInput(path, file => (Decode(file), Known(file).ReadText(file), Known(file).ReadLayers(file)));

    /// <summary>Returns whether a file is there and its first bytes are those of a picture or film.</summary>
    /// <param name="path">The file.</param>
    public static bool IsImage(string path) => FormatOf(path) is not null;

    /// <summary>Returns the format that the first bytes of a file are those of; null for any other file, or none.</summary>
    /// <param name="path">The file.</param>
    public static ImageFormat? FormatOf(string path)
    {
        try
        {
            // Looking into a pipe, whose length is 0, would take from it.
            FileInfo file = new(path);
            if ((file.LinkTarget is null ? file : file.ResolveLinkTarget(returnFinalTarget: true)) is not FileInfo { Exists: true, Length: > 0 })
            {
                return null;
            }

            using FileStream stream = new(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 1);
            Span<byte> bytes = stackalloc byte[ImageFormat.HeadLength];
            return ImageFormat.Of(bytes[..stream.ReadAtLeast(bytes, bytes.Length, throwOnEndOfStream: false)]);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            return null;
        }
    }

    /// <summary>Reads what a picture file says of itself, without its pixels.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="PictureException">As for <see cref="Read"/>.</exception>
    public static ImageDescription Describe(string path) => OfFile(path, file => Describe(file) with { FileBytes = file.Length });

    /// <summary>Reads what a picture file in memory says of itself, without its pixels.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">As for <see cref="Decode"/>.</exception>
    public static ImageDescription Describe(ReadOnlySpan<byte> file) => Known(file).Describe(file);

    /// <summary>
    /// Reads the texts that a picture file carries, in their order; of a PFM, none. Comments of a JPEG that name no key are called
    /// "Comment".
    /// </summary>
    /// <param name="path">The file.</param>
    /// <exception cref="PictureException">As for <see cref="Read"/>.</exception>
    public static IReadOnlyList<KeyValuePair<string, string>> ReadText(string path) => OfFile(path, file => Known(file).ReadText(file));

    /// <summary>Writes an image, row by row, in the format of the extension, whole or not at all (<see cref="AtomicFile"/>).</summary>
    /// <param name="path">The file; its folder must exist.</param>
    /// <param name="image">Linear RGB.</param>
    /// <param name="options">Details; by default 8 bits, JPEG of quality 90, no tone map, OpenEXR of halves with ZIP, no metadata.</param>
    /// <exception cref="ImageWriteException">
    /// The extension is unknown, the options cannot be met, or the file cannot be written.
    /// </exception>
    public static void Write(string path, IImageRows image, ImageWriteOptions? options = null)
    {
        ImageFormat format = Named(path);
        options ??= new ImageWriteOptions();
        try
        {
            AtomicFile.Write(path, stream => Encode(stream, format, image, options));
        }
        catch (ArgumentException e)
        {
            string message = e.Message.Split(" (Parameter '")[0];
            throw new ImageWriteException($"Cannot write '{path}': {message}", e);
        }
    }

    /// <summary>Writes an image to memory, in the format that an extension names.</summary>
    /// <param name="extension">The extension, with its dot.</param>
    /// <param name="image">Linear RGB.</param>
    /// <param name="options">As for <see cref="Write"/>.</param>
    /// <exception cref="ImageWriteException">The extension is unknown.</exception>
    public static byte[] Encode(string extension, IImageRows image, ImageWriteOptions options)
    {
        using MemoryStream stream = new();
        Encode(stream, Named($"picture{extension}"), image, options);
        return stream.ToArray();
    }

    /// <summary>Checks before a long computation that the extension is known and the folder exists.</summary>
    /// <param name="path">The file in which an image is to be written.</param>
    /// <param name="others">Extensions of files that are no images, and would do too.</param>
    /// <exception cref="ImageWriteException">It cannot be written there.</exception>
    public static void Check(string path, params string[] others)
    {
        Named(path, others);
        AtomicFile.Check(path);
    }

    private static void Encode(Stream stream, ImageFormat format, IImageRows image, ImageWriteOptions options)
    {
        bool isForDisplay = format.Features.HasFlag(ImageFeatures.Display);
        IImageRows shown = isForDisplay && options.Alpha is { } alpha ? new StraightRows(image, alpha) : image;
        format.Write(stream, isForDisplay ? options.Shown(shown) : image, options);
    }

    private const int LongestExtension = 16;

    private static ImageFormat Named(string path, params string[] others)
    {
        if (ImageFormat.OfName(path) is { } format)
        {
            return format;
        }

        string extension = Path.GetExtension(path).ToLowerInvariant();
        string[] all = [.. ImageFormat.Written().SelectMany(f => f.Extensions), .. others];
        string has = extension.Length > 0 ? $"the extension '{extension}' is none of" : "its name has none of the extensions";
        string? nearest = extension.Length > LongestExtension ? null
            : all.Where(known => EditDistance.Between(extension, known) <= 2).MinBy(known => EditDistance.Between(extension, known));
        string question = nearest is null ? "" : $" (did you mean '{nearest}'?)";
        throw new ImageWriteException($"Cannot write '{path}': {has} {string.Join(", ", all)}{question}.");
    }

    private static ImageFormat Known(ReadOnlySpan<byte> file) => ImageFormat.Of(file)
        ?? throw new PictureException($"its first bytes are not those of a supported picture format ({ImageFormat.Names()})");

    /// <summary>As <see cref="OfFile"/>, of a picture that is read to make another file of it.</summary>
    private static T OfInput<T>(string path, Func<byte[], T> read)
    {
        InputFiles.Add(path);
        return OfFile(path, read);
    }

    /// <summary>Reads something from a file, or from its beginning.</summary>
    /// <param name="path">The file.</param>
    /// <param name="read">Reads it.</param>
    /// <param name="what">The name of the file in messages.</param>
    /// <param name="atMost">The largest number of bytes to read.</param>
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

        Require(stream.Length <= Array.MaxLength || atMost is not null, $"it has {stream.Length} bytes, more than 2 GiB");

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

/// <summary>A file that cannot be written; the message says in one sentence what is wrong, for the user.</summary>
public sealed class ImageWriteException : Exception
{
    /// <summary>Says what is wrong.</summary>
    public ImageWriteException(string message) : base(message)
    {
    }

    /// <summary>Says what is wrong, and what caused it.</summary>
    public ImageWriteException(string message, Exception innerException) : base(message, innerException)
    {
    }

    /// <summary>An unnamed fault.</summary>
    public ImageWriteException()
    {
    }
}
