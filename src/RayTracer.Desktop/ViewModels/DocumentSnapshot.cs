using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A document as the window shows it, read off the window's thread.</summary>
/// <param name="Revision">The text's revision.</param>
/// <param name="Text">The text.</param>
/// <param name="Selection">The selected thing; null where there is none.</param>
/// <param name="Outline">The outline of the scene; null before a text could be read.</param>
/// <param name="Values">The values at the places that panels show, by their pointers.</param>
internal sealed record DocumentSnapshot(int Revision, string Text, string? Selection, Outline? Outline, IReadOnlyDictionary<string, PropertyValues> Values)
{
    /// <summary>That of a session.</summary>
    public static DocumentSnapshot Of(StudioSession session)
    {
        (int revision, string text) = session.Document.Current;
        string? selection = session.Selection.Pointer;
        try
        {
            Scenes.JsonNode root = session.Document.Readable.Root;
            IEnumerable<string> pointers = TypeCatalogue.Instance.Sections["scene"].Parameters.Select(p => $"/{p.Key}").Append(selection).OfType<string>().Distinct();
            return new(revision, text, selection, Outline.Of(revision, root), ValuesAt(root, pointers));
        }
        catch (SessionException)
        {
            return new(revision, text, selection, null, new Dictionary<string, PropertyValues>());
        }
    }

    private static Dictionary<string, PropertyValues> ValuesAt(Scenes.JsonNode root, IEnumerable<string> pointers)
    {
        Dictionary<string, PropertyValues> values = new(StringComparer.Ordinal);
        foreach (string pointer in pointers)
        {
            try
            {
                values.Add(pointer, PropertyValues.At(root, pointer));
            }
            catch (SessionException)
            {
                // It is not in the text that can be read.
            }
        }

        return values;
    }
}
