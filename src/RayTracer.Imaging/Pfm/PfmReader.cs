using System.Buffers.Binary;
using System.Globalization;
using System.Text;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>Reads portable float maps (Debevec's PFM): colour (PF) and grey (Pf), either byte order, rows from bottom to top.</summary>
internal static class PfmReader
{
    private const int LongestWord = 32;

    /// <summary>Returns whether a file begins as a portable float map does.</summary>
    public static bool IsPfm(ReadOnlySpan<byte> file) =>
        file.Length > 2 && file[0] == 'P' && file[1] is (byte)'F' or (byte)'f' && IsSpace(file[2]);

    /// <summary>
    /// Reads a picture. Values are taken as they are, bit for bit; of the scale only the sign counts, which is the byte order.
    /// </summary>
    /// <param name="file">The whole file.</param>
    /// <returns>The values as linear RGB; grey has three equal channels.</returns>
    /// <exception cref="PictureException">The file is no PFM, is cut off, or is beyond <see cref="PictureLimits"/>.</exception>
    public static Picture Read(ReadOnlySpan<byte> file)
    {
        (int channels, int width, int height, float factor) = Header(file, out ReadOnlySpan<byte> rest);
        rest = rest.IsEmpty ? rest : rest[1..];
        long needed = 4L * channels * width * height;
        Require(rest.Length >= needed, $"the file is cut off: {width}×{height} pixels need {needed} bytes, and {rest.Length} are left");

        Picture picture = PictureLimits.Allocate(width, height);
        int rowBytes = 4 * channels * width;
        for (int y = height - 1; y >= 0; y--)
        {
            ReadRow(rest[..rowBytes], channels, bigEndian: factor > 0, picture.Pixels.AsSpan(3 * y * width, 3 * width));
            rest = rest[rowBytes..];
        }

        return picture;
    }

    /// <summary>Reads what a file says of itself.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">Its header is damaged.</exception>
    internal static ImageDescription Describe(ReadOnlySpan<byte> file)
    {
        (int channels, int width, int height, float factor) = Header(file, out _);
        string[] names = channels == 3 ? ["R", "G", "B"] : ["Y"];
        return new("PFM", width, height, factor > 0 ? "none, big-endian" : "none, little-endian", ImageChannel.Of("float", 32, names), []);
    }

    private static (int Channels, int Width, int Height, float Factor) Header(ReadOnlySpan<byte> file, out ReadOnlySpan<byte> rest)
    {
        Require(IsPfm(file), "it does not begin as a PFM file does");

        rest = file[2..];
        int width = Size(Word(ref rest), "width");
        int height = Size(Word(ref rest), "height");
        PictureLimits.CheckSize(width, height);
        string scale = Word(ref rest);
        return float.TryParse(scale, NumberStyles.Float, CultureInfo.InvariantCulture, out float factor) && factor != 0 && float.IsFinite(factor)
            ? (file[1] == 'F' ? 3 : 1, width, height, factor)
            : throw new PictureException($"its scale '{Shown(scale)}' is not a number other than 0");
    }

    private static void ReadRow(ReadOnlySpan<byte> bytes, int channels, bool bigEndian, Span<float> row)
    {
        for (int i = 0; i < row.Length; i++)
        {
            ReadOnlySpan<byte> value = bytes[(4 * (channels == 3 ? i : i / 3))..];
            row[i] = bigEndian ? BinaryPrimitives.ReadSingleBigEndian(value) : BinaryPrimitives.ReadSingleLittleEndian(value);
        }
    }

    // Skips white space and takes the word after it; the one white space that ends the word stays.
    private static string Word(ref ReadOnlySpan<byte> rest)
    {
        int begin = 0;
        while (begin < rest.Length && IsSpace(rest[begin]))
        {
            begin++;
        }

        int end = begin;
        while (end < rest.Length && end - begin < LongestWord && !IsSpace(rest[end]))
        {
            end++;
        }

        string word = Encoding.Latin1.GetString(rest[begin..end]);
        rest = rest[end..];
        return word;
    }

    private static int Size(string word, string name) =>
        int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out int size)
            ? size
            : throw new PictureException($"its {name} '{Shown(word)}' is not a whole number");

    private static string Shown(string word) => string.Concat(word.Select(c => c is >= ' ' and <= '~' ? c : '?'));

    private static bool IsSpace(byte b) => b is (byte)' ' or (byte)'\t' or (byte)'\n' or (byte)'\r';
}
