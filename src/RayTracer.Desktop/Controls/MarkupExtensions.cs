using Avalonia.Media;
using RayTracer.Session;

namespace RayTracer.Desktop.Controls;

/// <summary>An icon of the session, in XAML: <c>{c:Icon reset}</c>.</summary>
/// <param name="name">Its name.</param>
public sealed class IconExtension(string name)
{
    /// <summary>Its lines.</summary>
    public Geometry ProvideValue(IServiceProvider services) => Geometry.Parse(SessionCommand.IconOf(name));
}

/// <summary>A text of the session, in XAML: <c>{c:Text viewport.exposure}</c>.</summary>
/// <param name="place">Its place among the texts.</param>
public sealed class TextExtension(string place)
{
    /// <summary>The text.</summary>
    public string ProvideValue(IServiceProvider services) => SessionTexts.Of(place);
}
