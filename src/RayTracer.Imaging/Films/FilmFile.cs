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

    private const int Version = 3;

    // The same, without planes.
    private const int OldestVersion = 2;
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

        IReadOnlyList<FilmPlane> kept = film.KeptPlanes;
        byte[] text = (header with { Planes = kept }).ToBytes();
        byte[] front = new byte[FrontLength];
        Signature.CopyTo(front);
        BinaryPrimitives.WriteInt32LittleEndian(front.AsSpan(8), Version);
        BinaryPrimitives.WriteInt32LittleEndian(front.AsSpan(12), text.Length);
        Put(front);
        Put(text);
        PutCheck();
        byte[] row = new byte[1 + ((long)film.Width * Film.BytesPerPixel)];
        Int128[] sums = new Int128[(long)film.Width * SumsPerPixel];
        Int128[][] planes = [.. kept.Select(p => new Int128[(long)film.Width * p.Sums.Count])];
        byte[] plane = new byte[1 + (16L * planes.Max(p => (int?)p.Length) ?? 0)];
        uint[] counts = new uint[film.Width];
        for (int y = 0; y < film.Height; y++)
        {
            film.ReadSums(y, sums, counts);
            Put(row.AsSpan(0, EncodeRow(sums, counts, row)));
            for (int i = 0; i < planes.Length; i++)
            {
                film.ReadPlane(kept[i], y, planes[i]);
                Put(plane.AsSpan(0, EncodePlane(planes[i], plane)));
            }

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
        Film film = new(header.Width, header.Height, header.WithKnownPlanes().Planes);
        AddRows(input, film, header.Planes, []);
        return (header, film);
    }

    /// <summary>Adds the samples of a file to a film of its size, and to the planes that the film has.</summary>
    /// <param name="path">The file.</param>
    /// <param name="film">The film.</param>
    /// <param name="adding">
    /// One of these is held while a row is added: with the same ones, several files may be added at once. (The sums are exact: their order
    /// does not matter.)
    /// </param>
    /// <exception cref="PictureException">It cannot be read, or is damaged: the film then holds a part of the samples.</exception>
    /// <exception cref="ArgumentException">The sizes differ, or the file lacks a plane.</exception>
    public static FilmHeader AddTo(string path, Film film, params Lock[] adding) => OfFile(path, stream =>
    {
        FilmInput input = new(stream);
        FilmHeader header = Open(input, stream.Length);
        if ((header.Width, header.Height) != (film.Width, film.Height))
        {
            throw new ArgumentException($"it has {header.Width}×{header.Height} pixels, not {film.Width}×{film.Height}", nameof(film));
        }

        AddRows(input, film, PlanesFor(film, header), adding);
        return header;
    });

    /// <summary>Returns whether sums need more than 64 bits.</summary>
    internal static bool AreWide(Int128[] sums) => Array.Exists(sums, s => s < long.MinValue || s > long.MaxValue);

    /// <summary>Returns the planes of a film in a file, of which another one takes those that it has.</summary>
    /// <exception cref="ArgumentException">The file lacks one.</exception>
    internal static IReadOnlyList<FilmPlane> PlanesFor(Film film, FilmHeader header) =>
        film.Planes.Except(header.Planes).FirstOrDefault() is { } missing
            ? throw new ArgumentException($"it has no plane '{missing}'", nameof(header)) : header.WithKnownPlanes().Planes;

    // A row is a byte of flags, the counts (one where all are equal), and the sums (of 8 bytes where all fit into them, else of 16).
    private static int EncodeRow(Int128[] sums, uint[] counts, byte[] row)
    {
        bool equal = !counts.AsSpan().ContainsAnyExcept(counts[0]);
        ReadOnlySpan<byte> numbers = MemoryMarshal.AsBytes(counts.AsSpan(0, equal ? 1 : counts.Length));
        numbers.CopyTo(row.AsSpan(1));
        return EncodeSums(sums, row, equal ? EqualCounts : (byte)0, 1 + numbers.Length);
    }

    // A plane's row is the same without counts.
    private static int EncodePlane(Int128[] sums, byte[] row) => EncodeSums(sums, row, 0, 1);

    private static int EncodeSums(Int128[] sums, byte[] row, byte flags, int length)
    {
        bool wide = AreWide(sums);
        row[0] = (byte)(flags | (wide ? WideSums : 0));
        if (wide)
        {
            ReadOnlySpan<byte> bytes = MemoryMarshal.AsBytes(sums.AsSpan());
            bytes.CopyTo(row.AsSpan(length));
            return length + bytes.Length;
        }

        foreach (Int128 sum in sums)
        {
            BinaryPrimitives.WriteInt64LittleEndian(row.AsSpan(length), (long)sum);
            length += sizeof(long);
        }

        return length;
    }

    private static FilmHeader Open(FilmInput input, long fileLength)
    {
        byte[] front = new byte[FrontLength];
        input.Fill(front);
        Require(front.AsSpan().StartsWith(Signature), "it is not a film: its first bytes do not match");

        int version = BinaryPrimitives.ReadInt32LittleEndian(front.AsSpan(8));
        Require(
            version is >= OldestVersion and <= Version, $"its format has version {version}, but only {OldestVersion} to {Version} are known");

        int length = BinaryPrimitives.ReadInt32LittleEndian(front.AsSpan(12));
        Require(length is not (< 2 or > LongestHeader) && length <= fileLength, $"its header cannot have {length} bytes");

        byte[] text = new byte[length];
        input.Fill(text);
        input.Check("its header");
        FilmHeader header = FilmHeader.Of(text);

        // Before any memory is taken for them: each sum takes 8 bytes at least.
        Int128 sums = SumsPerPixel + header.Planes.Sum(p => (long)p.Sums.Count);
        Int128 least = (Int128)header.Height * (9 + header.Planes.Count + (header.Width * 8 * sums));
        return fileLength >= least && (Int128)header.Width * header.Height <= Film.MaxPixels
            ? header
            : throw new PictureException($"it is too short for {header.Width}×{header.Height} pixels");
    }

    private static void AddRows(FilmInput input, Film film, IReadOnlyList<FilmPlane> planes, Lock[] adding)
    {
        input.ReadAhead();
        try
        {
            byte[] bytes = new byte[(long)film.Width * SumsPerPixel * 8];
            byte[][] planeBytes = [.. planes.Select(p => new byte[(long)film.Width * p.Sums.Count * 8])];
            bool[] areWide = new bool[planes.Count];
            uint[] counts = new uint[film.Width];
            for (int y = 0; y < film.Height; y++)
            {
                bool isWide = ReadRow(input, counts, ref bytes);
                for (int i = 0; i < planes.Count; i++)
                {
                    input.Fill(planeBytes[i].AsSpan(0, 1));
                    areWide[i] = ReadSums(input, planeBytes[i][0], film.Width * planes[i].Sums.Count, ref planeBytes[i]);
                }

                input.Check($"row {y}");
                lock (adding.Length > 0 ? adding[y % adding.Length] : new())
                {
                    AddRow(film, y, bytes, isWide, counts);
                    for (int i = 0; i < planes.Count; i++)
                    {
                        AddPlane(film, planes[i], y, planeBytes[i], areWide[i]);
                    }
                }
            }

            input.CheckEnd();
        }
        finally
        {
            input.Stop();
        }
    }

    // The sums come to stand at the beginning of the bytes; returns whether they are wide.
    private static bool ReadRow(FilmInput input, uint[] counts, ref byte[] bytes)
    {
        input.Fill(bytes.AsSpan(0, 1));
        byte flags = bytes[0];
        bool equal = (flags & EqualCounts) != 0;
        input.Fill(MemoryMarshal.AsBytes(counts.AsSpan(0, equal ? 1 : counts.Length)));
        if (equal)
        {
            counts.AsSpan().Fill(counts[0]);
        }

        return ReadSums(input, flags, counts.Length * SumsPerPixel, ref bytes);
    }

    private static bool ReadSums(FilmInput input, byte flags, int count, ref byte[] bytes)
    {
        bool wide = (flags & WideSums) != 0;
        int length = count * (wide ? 16 : 8);
        if (bytes.Length < length)
        {
            bytes = new byte[length];
        }

        input.Fill(bytes.AsSpan(0, length));
        return wide;
    }

    private static void AddRow(Film film, int y, ReadOnlySpan<byte> bytes, bool isWide, uint[] counts)
    {
        int sums = film.Width * SumsPerPixel;
        if (isWide)
        {
            film.AddSums(y, MemoryMarshal.Cast<byte, Int128>(bytes)[..sums], counts);
        }
        else
        {
            film.AddSums(y, MemoryMarshal.Cast<byte, long>(bytes)[..sums], counts);
        }
    }

    private static void AddPlane(Film film, FilmPlane plane, int y, ReadOnlySpan<byte> bytes, bool isWide)
    {
        int sums = film.Width * plane.Sums.Count;
        if (!film.Planes.Contains(plane))
        {
            return;
        }

        if (isWide)
        {
            film.AddPlane(plane, y, MemoryMarshal.Cast<byte, Int128>(bytes)[..sums]);
        }
        else
        {
            film.AddPlane(plane, y, MemoryMarshal.Cast<byte, long>(bytes)[..sums]);
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
