using System.Buffers.Binary;
using System.Numerics;
using System.Text;
using RayTracer.Description;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>
/// Reads STL files (3D Systems 1989), text and binary. Corners of equal positions become one. Normals are left out: they follow from the
/// order of the corners; and so are the two bytes behind each triangle, in which some programs put colours.
/// </summary>
internal static class StlReader
{
    private const int HeaderBytes = 80;
    private const int FirstTriangle = HeaderBytes + 4;
    private const int TriangleBytes = 50;
    private const int NormalBytes = 12;

    /// <summary>Reads a file.</summary>
    /// <exception cref="ModelException">Something is wrong with it.</exception>
    public static ImportedModel Read(string path)
    {
        List<string> notes = [];
        MeshData mesh = Parse(ModelBytes.Read(path), notes);
        // Programs that make and print solids have z upwards.
        return MeshModel.Of(path, mesh, notes) with { Up = Vector3.UnitZ };
    }

    /// <summary>Reads the content of a file.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="notes">Receives what is odd about it.</param>
    /// <exception cref="ModelException">Something is wrong with it.</exception>
    public static MeshData Parse(ReadOnlySpan<byte> file, List<string> notes)
    {
        long claimed = file.Length < FirstTriangle ? -1 : BinaryPrimitives.ReadUInt32LittleEndian(file[HeaderBytes..]);
        long end = FirstTriangle + (claimed * TriangleBytes);

        // Some binary files begin with "solid", too: so a size that fits to the byte is better evidence.
        bool isBinary = claimed >= 0 && (end == file.Length || !IsText(file));
        if (!isBinary)
        {
            return IsText(file) ? ParseText(file) : throw new ModelException("it is not an STL file: it neither starts with \"solid\" nor has the 84 bytes of a binary file");
        }

        ModelCheck.Require(end <= file.Length, $"byte {HeaderBytes}: {claimed} triangles would need {end} bytes, and the file has {file.Length}");

        if (end < file.Length)
        {
            notes.Add($"{file.Length - end} bytes after the last triangle are ignored");
        }

        return ParseBinary(file.Slice(FirstTriangle, (int)(claimed * TriangleBytes)));
    }

    // Text begins with the word solid and has no zero bytes near its begin.
    private static bool IsText(ReadOnlySpan<byte> file)
    {
        var text = new ModelText(file);
        return text.SkipToWord() && Ascii.EqualsIgnoreCase(text.Word(), "solid"u8) && !file[..Math.Min(file.Length, 1024)].Contains((byte)0);
    }

    private static MeshData ParseBinary(ReadOnlySpan<byte> triangles)
    {
        var corners = new CornerTable(triangles.Length / TriangleBytes);
        for (; !triangles.IsEmpty; triangles = triangles[TriangleBytes..])
        {
            for (int corner = 0; corner < 3; corner++)
            {
                ReadOnlySpan<byte> position = triangles[(NormalBytes * (1 + corner))..];
                corners.Add(new Vector3(Coordinate(position), Coordinate(position[4..]), Coordinate(position[8..])));
            }
        }

        return corners.ToMesh();
    }

    private static float Coordinate(ReadOnlySpan<byte> bytes) => BinaryPrimitives.ReadSingleLittleEndian(bytes);

    // Of the words between, only those that separate triangles count: programs differ in the rest.
    private static MeshData ParseText(ReadOnlySpan<byte> file)
    {
        // The shortest triangle, "vertex 0 0 0" thrice and "endloop", has more than 32 bytes.
        var corners = new CornerTable(file.Length / 256);
        var text = new ModelText(file);
        Span<Vector3> loop = stackalloc Vector3[3];
        int count = 0;
        while (text.SkipToWord())
        {
            int begin = text.Position;
            ReadOnlySpan<byte> word = text.Word();
            if (Is(word, "vertex"u8))
            {
                loop[count % 3] = new Vector3(text.Number(acrossLines: true), text.Number(acrossLines: true), text.Number(acrossLines: true));
                count++;
            }
            else if (Is(word, "endloop"u8))
            {
                Require(count == 3, text, begin, $"a loop has {count} corners instead of 3");
                corners.Add(loop[0]);
                corners.Add(loop[1]);
                corners.Add(loop[2]);
                count = 0;
            }
            else if (Is(word, "solid"u8) || Is(word, "endsolid"u8))
            {
                text.SkipLine(); // a name of any words
            }
            else if (Is(word, "normal"u8))
            {
                SkipWords(ref text, 3); // which some programs write as nan or 1.#IND
            }
            else
            {
                bool isKnown = Is(word, "facet"u8) || Is(word, "outer"u8) || Is(word, "loop"u8) || Is(word, "endfacet"u8);
                Require(isKnown, text, begin, $"expected facet, vertex, endloop or another word of STL instead of {Quotation.Of(ModelText.Decode(word[..Math.Min(word.Length, 200)]))}");
            }
        }

        Require(count == 0, text, file.Length, "the file is cut off within a triangle");
        return corners.ToMesh();
    }

    private static void SkipWords(ref ModelText text, int count)
    {
        for (int i = 0; i < count && text.SkipToWord(); i++)
        {
            text.Word();
        }
    }

    private static bool Is(ReadOnlySpan<byte> word, ReadOnlySpan<byte> keyword) => Ascii.EqualsIgnoreCase(word, keyword);

    private static void Require(bool condition, in ModelText text, int position, string otherwise)
    {
        if (!condition)
        {
            throw text.ErrorAt(position, otherwise);
        }
    }
}
