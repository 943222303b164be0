using System.Xml;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>Reads XML files into elements. There are no document types and no entities of files, so nothing else is ever opened.</summary>
internal static class MitsubaXml
{
    /// <summary>The maximum depth of nested elements.</summary>
    public const int MaximumNesting = 64;

    /// <summary>Reads a file.</summary>
    /// <param name="path">The file's path, by which diagnostics call it too.</param>
    /// <param name="log">Takes what is wrong.</param>
    /// <returns>The outermost element; null where there is something wrong with the XML.</returns>
    public static MitsubaElement? Read(string path, ImportLog log)
    {
        SourcePlace file = new(path, 0, 0);
        try
        {
            if (FileSearch.Complaint(path) is { } complaint)
            {
                return log.Fail<MitsubaElement>(file, complaint);
            }

            using FileStream stream = File.OpenRead(path);
            if (stream.Length > SceneReader.MaximumBytes)
            {
                return log.Fail<MitsubaElement>(file, $"larger than {SceneReader.MaximumBytes >> 20} MiB");
            }

            XmlReaderSettings settings = new()
            {
                DtdProcessing = DtdProcessing.Prohibit,
                XmlResolver = null,
                IgnoreComments = true,
                IgnoreProcessingInstructions = true,
                IgnoreWhitespace = true,
            };
            using XmlReader reader = XmlReader.Create(stream, settings);
            return ReadRoot(reader, path, log);
        }
        catch (XmlException e) when (e.LineNumber == 0 && e.Message.Contains("DTD", StringComparison.Ordinal))
        {
            log.Error(file, "a document type (<!DOCTYPE …>) is not read: leave it out");
        }
        catch (XmlException e)
        {
            log.Error(new(path, e.LineNumber, e.LinePosition), $"this is not XML: {Reason(e)}");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            log.Error(file, $"cannot be read: {e.Message.TrimEnd('.')}");
        }

        return null;
    }

    private static MitsubaElement? ReadRoot(XmlReader reader, string path, ImportLog log)
    {
        MitsubaElement? root = null;
        Stack<MitsubaElement> open = [];
        while (reader.Read())
        {
            switch (reader.NodeType)
            {
                case XmlNodeType.Element:
                    if (open.Count == MaximumNesting)
                    {
                        return log.Fail<MitsubaElement>(Place(reader, path), $"elements are nested more than {MaximumNesting} deep");
                    }

                    bool isClosed = reader.IsEmptyElement;
                    MitsubaElement element = ReadElement(reader, path);
                    root ??= element;
                    if (open.TryPeek(out MitsubaElement? parent))
                    {
                        parent.Children.Add(element);
                    }

                    if (!isClosed)
                    {
                        open.Push(element);
                    }

                    break;
                case XmlNodeType.EndElement:
                    open.Pop();
                    break;
                case XmlNodeType.Text or XmlNodeType.CDATA:
                    log.Error(Place(reader, path), $"text has no meaning here: {Quotation.Of(reader.Value.Trim())}");
                    break;
            }
        }

        return root;
    }

    private static MitsubaElement ReadElement(XmlReader reader, string path)
    {
        MitsubaElement element = new(reader.Name, Place(reader, path));
        while (reader.MoveToNextAttribute())
        {
            element.Attributes[reader.Name] = new(reader.Value, Place(reader, path));
        }

        reader.MoveToElement();
        return element;
    }

    private static SourcePlace Place(XmlReader reader, string path)
    {
        var lines = (IXmlLineInfo)reader;
        return new(path, lines.LineNumber, lines.LinePosition);
    }

    // The message without the line and position at its end, which are reported in front.
    private static string Reason(XmlException e)
    {
        int end = e.Message.LastIndexOf(" Line ", StringComparison.Ordinal);
        return (end > 0 ? e.Message[..end] : e.Message).TrimEnd('.');
    }
}

/// <summary>An attribute of an XML element.</summary>
/// <param name="Value">Its value.</param>
/// <param name="Place">The position of its name.</param>
internal readonly record struct MitsubaAttribute(string Value, SourcePlace Place);

/// <summary>An XML element, and where it stands.</summary>
/// <param name="name">Its name.</param>
/// <param name="place">The position of its name.</param>
internal sealed class MitsubaElement(string name, SourcePlace place)
{
    /// <summary>Its name.</summary>
    public string Name => name;

    /// <summary>The place of its name.</summary>
    public SourcePlace Place => place;

    /// <summary>The attributes by their names.</summary>
    public Dictionary<string, MitsubaAttribute> Attributes { get; } = new(StringComparer.Ordinal);

    /// <summary>The elements within it.</summary>
    public List<MitsubaElement> Children { get; init; } = [];

    /// <summary>The value of an attribute; null where there is none.</summary>
    public string? Attribute(string attribute) => Attributes.TryGetValue(attribute, out MitsubaAttribute found) ? found.Value : null;

    /// <summary>The place of an attribute, or of the element where there is none.</summary>
    public SourcePlace PlaceOf(string attribute) => Attributes.TryGetValue(attribute, out MitsubaAttribute found) ? found.Place : place;
}
