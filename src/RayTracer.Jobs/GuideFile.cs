using System.Runtime.InteropServices;
using System.Text;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>
/// A file that keeps what was learned before a picture: the content hash of the scene, the two tables, and their hash. Little-endian.
/// </summary>
/// <param name="path">The file.</param>
/// <param name="content">The content hash of the whole scene.</param>
internal sealed class GuideFile(string path, string content)
{
    private const int MostWords = 1 << 27;
    private static readonly byte[] s_signature = "RTGUIDE1"u8.ToArray();

    /// <summary>Reads it.</summary>
    /// <returns>The guide; null where there is no file.</returns>
    /// <exception cref="JobException">It is no such file, damaged, or of another scene.</exception>
    public PathGuide? Read()
    {
        if (!File.Exists(path))
        {
            return null;
        }

        InputFiles.Add(path);
        try
        {
            using BinaryReader reader = new(File.OpenRead(path), Encoding.UTF8);
            return reader.ReadBytes(s_signature.Length).AsSpan().SequenceEqual(s_signature) ? Read(reader) : throw Damaged(null);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or FormatException)
        {
            throw Damaged(e);
        }
    }

    /// <summary>Writes it.</summary>
    /// <exception cref="ImageWriteException">It cannot be written.</exception>
    public void Write(PathGuide guide) => AtomicFile.Write(path, stream =>
    {
        using BinaryWriter writer = new(stream, Encoding.UTF8, leaveOpen: true);
        writer.Write(s_signature);
        writer.Write(content);
        writer.Write(guide.Hash);
        Write(writer, guide.Space);
        Write(writer, guide.Nodes);
    });

    private static void Write(BinaryWriter writer, ReadOnlySpan<uint> table)
    {
        writer.Write(table.Length);
        writer.Write(MemoryMarshal.AsBytes(table));
    }

    private PathGuide Read(BinaryReader reader)
    {
        if (reader.ReadString() != content)
        {
            throw new JobException(JobFault.File, $"--guide-file '{path}' was learned of another scene, other settings or by another version: delete it, or give another name, and it is learned again");
        }

        string hash = reader.ReadString();
        PathGuide guide = new(Table(reader), Table(reader));
        return guide.Hash == hash && guide.IsWhole ? guide : throw Damaged(null);
    }

    private uint[] Table(BinaryReader reader)
    {
        int length = reader.ReadInt32();
        if (length is < 0 or > MostWords || length * (long)sizeof(uint) > reader.BaseStream.Length - reader.BaseStream.Position)
        {
            throw Damaged(null);
        }

        uint[] table = new uint[length];
        reader.BaseStream.ReadExactly(MemoryMarshal.AsBytes(table.AsSpan()));
        return table;
    }

    private JobException Damaged(Exception? inner) =>
        new($"--guide-file '{path}' is no guide, or damaged: delete it, and it is learned again", inner!);
}
