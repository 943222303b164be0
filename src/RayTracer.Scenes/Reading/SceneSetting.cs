namespace RayTracer.Scenes;

/// <summary>
/// A value that overrides one of a scene file, written <c>camera.fieldOfView=35</c>. Elements of lists are named by their numbers from 0
/// (<c>shapes[2].radius=1</c>) or by their names (<c>shapes.globe.radius=1</c>); names in which signs of the path occur stand in brackets and double quotes (<see cref="PropertyPath"/>).
/// The value is JSON; a word without quotes is a string.
/// </summary>
public sealed class SceneSetting
{
    private SceneSetting(string text, PropertyPath property) => (Text, Property) = (text, property);

    /// <summary>Path and value, as they were written.</summary>
    public string Text { get; }

    /// <summary>The path, as it was written.</summary>
    public string Path => Property.Text;

    /// <summary>The value, as it was written.</summary>
    public string Value => Text[ValueStart..];

    internal PropertyPath Property { get; }

    internal int ValueStart => Property.End + 1;

    /// <summary>Reads path and value.</summary>
    /// <param name="text">The text.</param>
    /// <exception cref="FormatException">It has no path, or no =; the message says what was expected.</exception>
    public static SceneSetting Parse(string text)
    {
        PropertyPath property = PropertyPath.Read(text, '=');
        return property.Complaint is null ? new(text, property)
            : throw new FormatException($"{property.Complaint}: settings are written PATH=VALUE, as in camera.fieldOfView=35");
    }
}
