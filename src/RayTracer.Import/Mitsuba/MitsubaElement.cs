using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>An attribute of an XML element.</summary>
/// <param name="Value">Its value.</param>
/// <param name="Place">Where its name begins.</param>
internal readonly record struct MitsubaAttribute(string Value, SourcePlace Place);

/// <summary>An XML element, and where it stands.</summary>
/// <param name="name">Its name.</param>
/// <param name="place">Where its name begins.</param>
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
