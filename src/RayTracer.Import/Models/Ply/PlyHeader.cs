using System.Text;
using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>A number, or a list of numbers, that each thing of a kind has.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Type">The numbers' type.</param>
/// <param name="CountType">For a list, the type of its length; null for one number.</param>
internal sealed record PlyProperty(string Name, PlyType Type, PlyType? CountType)
{
    /// <summary>The fewest bytes that it takes in a binary file.</summary>
    public int LeastSize => CountType?.Size() ?? Type.Size();
}

/// <summary>Things of one kind (vertices, faces …).</summary>
/// <param name="Name">Its name.</param>
/// <param name="Count">The number of elements, according to the header.</param>
/// <param name="Line">The line of the header that says so.</param>
internal sealed record PlyElement(string Name, long Count, int Line)
{
    /// <summary>The properties of each of them, in order.</summary>
    public List<PlyProperty> Properties { get; } = [];
}

/// <summary>The encoding of a PLY file's numbers.</summary>
internal enum PlyFormat
{
    Ascii,
    BinaryLittleEndian,
    BinaryBigEndian,
}

/// <summary>The header of a PLY file (Turk 1994).</summary>
internal sealed class PlyHeader
{
    private static readonly string[] s_keywords = ["format", "element", "property", "comment", "obj_info", "end_header"];

    /// <summary>The oddities of the header.</summary>
    public List<string> Notes { get; } = [];

    /// <summary>The encoding of numbers.</summary>
    public PlyFormat Format { get; private set; }

    /// <summary>The elements that follow the header, in order.</summary>
    public List<PlyElement> Elements { get; } = [];

    /// <summary>Reads a header; the text then stands behind it.</summary>
    /// <exception cref="ModelException">It is no header of a PLY file.</exception>
    public static PlyHeader Parse(ref ModelText text)
    {
        if (!text.Word().SequenceEqual("ply"u8))
        {
            throw new ModelException("it does not begin with \"ply\" as a PLY file does", 1);
        }

        text.SkipLine();
        var header = new PlyHeader();
        bool hasFormat = false;
        while (true)
        {
            if (text.IsAtEnd)
            {
                throw text.Error("the header ends without end_header");
            }

            int begin = text.Position;
            string keyword = Encoding.Latin1.GetString(text.Word());
            switch (keyword)
            {
                case "format":
                    header.Format = ParseFormat(ref text);
                    hasFormat = true;
                    break;
                case "element":
                    header.Elements.Add(ParseElement(ref text));
                    break;
                case "property":
                    PlyElement element = header.Elements.LastOrDefault() ?? throw text.ErrorAt(begin, "a property comes before the first element");
                    element.Properties.Add(ParseProperty(ref text, element));
                    break;
                case "end_header":
                    text.SkipLine();
                    return hasFormat ? header : throw text.ErrorAt(begin, "the header does not say the format");
                case "comment" or "obj_info" or "":
                    break;
                default:
                    header.SkipStranger(keyword, text.Line);
                    break;
            }

            text.SkipLine();
        }
    }

    // Some programs forget the word "comment"; but a misspelt word must not be taken for that.
    private void SkipStranger(string keyword, int line)
    {
        if (Array.Find(s_keywords, k => EditDistance.Between(keyword[..Math.Min(keyword.Length, 20)], k) <= 2) is { } meant)
        {
            throw new ModelException($"expected {meant} instead of {Quotation.Of(keyword)}", line);
        }

        Notes.Add($"line {line} of its header is not a PLY statement and is taken for a comment");
    }

    private static PlyFormat ParseFormat(ref ModelText text)
    {
        ReadOnlySpan<byte> name = text.Word();
        return name.SequenceEqual("ascii"u8) ? PlyFormat.Ascii
            : name.SequenceEqual("binary_little_endian"u8) ? PlyFormat.BinaryLittleEndian
            : name.SequenceEqual("binary_big_endian"u8) ? PlyFormat.BinaryBigEndian
            : throw text.Expected("ascii, binary_little_endian or binary_big_endian", name);
    }

    private static PlyElement ParseElement(ref ModelText text)
    {
        string name = Encoding.Latin1.GetString(text.Word());
        ReadOnlySpan<byte> word = text.Word();
        return long.TryParse(word, System.Globalization.NumberStyles.None, null, out long count) && name.Length > 0
            ? new PlyElement(name, count, text.Line)
            : throw text.Expected("an element's name and count", word);
    }

    private static PlyProperty ParseProperty(ref ModelText text, PlyElement element)
    {
        ReadOnlySpan<byte> word = text.Word();
        PlyType? countType = null;
        if (word.SequenceEqual("list"u8))
        {
            countType = ParseType(ref text, text.Word());
            word = text.Word();
        }

        PlyType type = ParseType(ref text, word);
        string name = Encoding.Latin1.GetString(text.Word());
        if (name.Length == 0 || element.Properties.Exists(p => p.Name == name))
        {
            throw text.Error(name.Length == 0 ? "a property has no name" : $"{Quotation.Of(element.Name)} has two properties {Quotation.Of(name)}");
        }

        return new PlyProperty(name, type, countType);
    }

    private static PlyType ParseType(ref ModelText text, ReadOnlySpan<byte> name) =>
        PlyTypes.Parse(Encoding.Latin1.GetString(name)) ?? throw text.Expected("a type such as uchar, int or float", name);
}
