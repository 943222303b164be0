using System.Buffers.Binary;
using System.Runtime.InteropServices;
using RayTracer.Rendering;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>
/// Files that hold a film to the bit (.rtfilm): samples can be added to them later, and films of other samples of the same scene can be
/// merged. docs/long-renders.md describes the format: signature, version, header and rows, each with a check of all before.
/// </summary>
public static class FilmFile
{
    /// <summary>The extension of their names.</summary>
    public const string Extension = ".rtfilm";

    private const int Version = 2;
    private const int LongestHeader = 1 << 24;
    private const int FrontLength = 16;
    private const int SumsPerPixel = Film.BytesPerPixel / 16;
    private const byte EqualCounts = 1;
    private const byte WideSums = 2;

    /// <summary>The first bytes; as in PNG, line ends that are changed on the way show at once.</summary>
    public static ReadOnlySpan<byte> Signature => "RTFILM\r\n"u8;

    /// <summary>Returns whether a file's name says that it holds a film.</summary>
    public static bool IsNamed(string path) => path.EndsWith(Extension, StringComparison.OrdinalIgnoreCase);

    /// <summary>
    /// Writes a film. The file is there whole or not at all, and what was there before stays until then (<see cref="AtomicFile"/>).
    /// </summary>
    /// <exception cref="ImageWriteException">It cannot be written.</exception>
    public static void Write(string path, Film film, FilmHeader header) => AtomicFile.Write(path, stream =>
    {
        uint check = 0;
        void Put(ReadOnlySpan<byte> bytes)
        {
            check = Crc32C.Append(check, bytes);
            stream.Write(bytes);
        }

        void PutCheck()
        {
            Span<byte> bytes = stackalloc byte[sizeof(uint)];
            BinaryPrimitives.WriteUInt32LittleEndian(bytes, check);
            stream.Write(bytes);
        }

        byte[] text = header.ToBytes();
        byte[] front = new byte[FrontLength];
        Signature.CopyTo(front);
        BinaryPrimitives.WriteInt32LittleEndian(front.AsSpan(8), Version);
        BinaryPrimitives.WriteInt32LittleEndian(front.AsSpan(12), text.Length);
        Put(front);
        Put(text);
        PutCheck();
        byte[] row = new byte[1 + ((long)film.Width * Film.BytesPerPixel)];
        Int128[] sums = new Int128[(long)film.Width * SumsPerPixel];
        uint[] counts = new uint[film.Width];
        for (int y = 0; y < film.Height; y++)
        {
            film.ReadSums(y, sums, counts);
            Put(row.AsSpan(0, EncodeRow(sums, counts, row)));
            PutCheck();
        }
    });

    /// <summary>Reads what a file says about its film.</summary>
    /// <exception cref="PictureException">It cannot be read, or is damaged.</exception>
    public static FilmHeader ReadHeader(string path) => OfFile(path, stream => Open(new(stream), stream.Length));

    /// <summary>Reads a film.</summary>
    /// <exception cref="PictureException">It cannot be read, or is damaged.</exception>
    public static (FilmHeader Header, Film Film) Read(string path) => OfFile(path, Read);

    /// <summary>Reads a film from a stream that can seek.</summary>
    /// <exception cref="PictureException">It is damaged; the message is a clause.</exception>
    internal static (FilmHeader Header, Film Film) Read(Stream stream)
    {
        FilmInput input = new(stream);
        FilmHeader header = Open(input, stream.Length);
        Film film = new(header.Width, header.Height);
        AddRows(input, film, []);
        return (header, film);
    }

    /// <summary>Adds the samples of a file to a film of its size.</summary>
    /// <param name="path">The file.</param>
    /// <param name="film">The film.</param>
    /// <param name="adding">
    /// One of these is held while a row is added: with the same ones, several files may be added at once. (The sums are exact: their order
    /// does not matter.)
    /// </param>
    /// <exception cref="PictureException">It cannot be read, or is damaged: the film then holds a part of the samples.</exception>
    /// <exception cref="ArgumentException">The sizes differ.</exception>
    public static FilmHeader AddTo(string path, Film film, params Lock[] adding) => OfFile(path, stream =>
    {
        FilmInput input = new(stream);
        FilmHeader header = Open(input, stream.Length);
        if ((header.Width, header.Height) != (film.Width, film.Height))
        {
            throw new ArgumentException($"it has {header.Width}×{header.Height} pixels, not {film.Width}×{film.Height}", nameof(film));
        }

        AddRows(input, film, adding);
        return header;
    });

    /// <summary>Returns whether sums need more than 64 bits.</summary>
    internal static bool AreWide(Int128[] sums) => Array.Exists(sums, s => s < long.MinValue || s > long.MaxValue);

    // A row is a byte of flags, the counts (one where all are equal), and the sums (of 8 bytes where all fit into them, else of 16).
    private static int EncodeRow(Int128[] sums, uint[] counts, byte[] row)
    {
        bool equal = !counts.AsSpan().ContainsAnyExcept(counts[0]);
        bool wide = AreWide(sums);
        row[0] = (byte)((equal ? EqualCounts : 0) | (wide ? WideSums : 0));
        int length = 1;
        Copy(MemoryMarshal.AsBytes(counts.AsSpan(0, equal ? 1 : counts.Length)));
        if (wide)
        {
            Copy(MemoryMarshal.AsBytes(sums.AsSpan()));
            return length;
        }

        foreach (Int128 sum in sums)
        {
            BinaryPrimitives.WriteInt64LittleEndian(row.AsSpan(length), (long)sum);
            length += sizeof(long);
        }

        return length;

        void Copy(ReadOnlySpan<byte> bytes)
        {
            bytes.CopyTo(row.AsSpan(length));
            length += bytes.Length;
        }
    }

    private static FilmHeader Open(FilmInput input, long fileLength)
    {
        byte[] front = new byte[FrontLength];
        input.Fill(front);
        Require(front.AsSpan().StartsWith(Signature), "it is not a film: its first bytes do not match");

        int version = BinaryPrimitives.ReadInt32LittleEndian(front.AsSpan(8));
        Require(version == Version, $"its format has version {version}, but only {Version} is known");

        int length = BinaryPrimitives.ReadInt32LittleEndian(front.AsSpan(12));
        Require(length is not (< 2 or > LongestHeader) && length <= fileLength, $"its header cannot have {length} bytes");

        byte[] text = new byte[length];
        input.Fill(text);
        input.Check("its header");
        FilmHeader header = FilmHeader.Of(text);

        // Before any memory is taken for them: pixels take 32 bytes at least.
        Int128 least = (Int128)header.Height * (9 + ((Int128)header.Width * 8 * SumsPerPixel));
        return fileLength >= least && (Int128)header.Width * header.Height <= Film.MaxPixels
            ? header
            : throw new PictureException($"it is too short for {header.Width}×{header.Height} pixels");
    }

    private static void AddRows(FilmInput input, Film film, Lock[] adding)
    {
        input.ReadAhead();
        try
        {
            byte[] bytes = new byte[(long)film.Width * SumsPerPixel * 8];
            uint[] counts = new uint[film.Width];
            for (int y = 0; y < film.Height; y++)
            {
                AddRow(input, film, y, adding.Length > 0 ? adding[y % adding.Length] : new(), ref bytes, counts);
            }

            input.CheckEnd();
        }
        finally
        {
            input.Stop();
        }
    }

    private static void AddRow(FilmInput input, Film film, int y, Lock adding, ref byte[] bytes, uint[] counts)
    {
        input.Fill(bytes.AsSpan(0, 1));
        bool equal = (bytes[0] & EqualCounts) != 0;
        bool wide = (bytes[0] & WideSums) != 0;
        input.Fill(MemoryMarshal.AsBytes(counts.AsSpan(0, equal ? 1 : counts.Length)));
        if (equal)
        {
            counts.AsSpan().Fill(counts[0]);
        }

        int length = film.Width * SumsPerPixel * (wide ? 16 : 8);
        if (bytes.Length < length)
        {
            bytes = new byte[length];
        }

        Span<byte> sums = bytes.AsSpan(0, length);
        input.Fill(sums);
        input.Check($"row {y}");
        lock (adding)
        {
            if (wide)
            {
                film.AddSums(y, MemoryMarshal.Cast<byte, Int128>(sums), counts);
            }
            else
            {
                film.AddSums(y, MemoryMarshal.Cast<byte, long>(sums), counts);
            }
        }
    }

    private static T OfFile<T>(string path, Func<Stream, T> read)
    {
        try
        {
            using FileStream stream = new(path, FileMode.Open, FileAccess.Read, FileShare.Read | FileShare.Delete, 1 << 12, FileOptions.SequentialScan);
            return stream.CanSeek ? read(stream) : throw new PictureException("it is a pipe, but films are read from files");
        }
        catch (Exception e) when (e is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new PictureException($"Cannot read the film '{path}': there is no such file.", e);
        }
        catch (Exception e) when (e is PictureException or IOException or UnauthorizedAccessException)
        {
            throw new PictureException($"Cannot read the film '{path}': {e.Message.ReplaceLineEndings(" ").TrimEnd('.')}.", e);
        }
    }
}
