using System.Text;
using RayTracer.Textbook;

namespace RayTracer.Labs;

/// <summary>A single ray as a scene that the Studio opens: the ray as a thin red cylinder, and balls where it should end (green) and where it does (red).</summary>
public static class RayScene
{
    private const string Clear = "silver";

    /// <summary>Makes one.</summary>
    /// <param name="title">What it shows.</param>
    /// <param name="ray">The ray.</param>
    /// <param name="found">Its t by the student's function; null for none.</param>
    /// <param name="expected">The right t; null for none.</param>
    /// <param name="shapes">What it meets, each made by <see cref="Shape"/>.</param>
    public static Exhibit Show(string title, Ray ray, double? found, double? expected, params IEnumerable<string> shapes)
    {
        double speed = ray.Direction.Length;
        double end = new[] { found, expected }.Max(t => t is { } there && double.IsFinite(there) ? Math.Abs(there) : 0);
        double length = end > 0 ? 1.2 * end * speed : 5;
        Vector along = ray.Direction.Unit;
        Vector across = new Frame(along).ToWorld(new(0.8, 0.6, 0));
        Vector middle = ray.Origin + (0.5 * length * along);
        Vector eye = middle + (across * ((1.3 * length) + 4));
        double thin = 0.004 * length;
        string[] all =
        [
            .. shapes,
            Shape("cylinder", "crimson", ("bottom", ray.Origin), ("top", ray.Origin + (length * along)), ("radius", thin)),
            Shape("sphere", "royalblue", ("center", ray.Origin), ("radius", 3 * thin)),
            .. Ball(expected, "limegreen", 4), .. Ball(found, "red", 3),
        ];
        string scene = $$"""
            // {{title}}. The ray starts at the blue ball; it should end at the green one, and ends at the red one.
            {
              "camera": { "position": {{((Answer)eye).Json}}, "lookAt": {{((Answer)middle).Json}}, "fieldOfView": 50 },
              "render": { "width": 640, "height": 480, "samplesPerPixel": 16 },
              "background": "white",
              "shapes": [
                {{string.Join(",\n    ", all)}}
              ]
            }

            """;
        return new(title, "json", Encoding.UTF8.GetBytes(scene.ReplaceLineEndings("\n")));

        IEnumerable<string> Ball(double? t, string color, double size) => t is { } there && double.IsFinite(there)
            ? [Shape("sphere", color, ("center", ray.At(there)), ("radius", size * thin))] : [];
    }

    /// <summary>A shape as scene files have it; a silver one can be seen through, so that it does not hide the ray.</summary>
    /// <param name="type">The type.</param>
    /// <param name="color">The colour.</param>
    /// <param name="parameters">Its parameters: points and numbers.</param>
    public static string Shape(string type, string color, params IEnumerable<(string Name, Answer Value)> parameters)
    {
        string material = $$"""{ "type": "diffuse", "color": "{{color}}" }""";
        material = color == Clear ? $$"""{ "type": "mask", "opacity": 0.4, "material": {{material}} }""" : material;
        return $$"""{ "type": "{{type}}", {{string.Concat(parameters.Select(p => $"\"{p.Name}\": {p.Value.Json}, "))}}"material": {{material}} }""";
    }
}
