using RayTracer.Session;

namespace RayTracer.Desktop.Controls;

/// <summary>A text of the session, in XAML: <c>{c:Text viewport.exposure}</c>.</summary>
/// <param name="place">Its place among the texts.</param>
public sealed class TextExtension(string place)
{
    /// <summary>The text.</summary>
    public string ProvideValue(IServiceProvider services) => SessionTexts.Of(place);
}
