using System.Globalization;

namespace RayTracer.Scenes;

/// <summary>The place of an animated property in a scene, for programs that change scenes: the keys and indices that lead there, and their names in the path.</summary>
/// <param name="Steps">Keys, and the numbers of elements of lists from 0.</param>
/// <param name="IsNamed">Of each step, whether it is an element of a list that is called by its name.</param>
public sealed record PropertyAddress(IReadOnlyList<string> Steps, IReadOnlyList<bool> IsNamed)
{
    /// <summary>Finds a property.</summary>
    /// <param name="root">The scene.</param>
    /// <param name="path">The path, as in <c>shapes.ball.center[1]</c>.</param>
    /// <returns>The address; null where there is none.</returns>
    public static PropertyAddress? Find(JsonNode root, string path) =>
        PropertyPlace.Find(root, PropertyPath.Read(path)) is { Complaint: null } place
            ? new([.. place.Steps.Select(s => s.Index?.ToString(CultureInfo.InvariantCulture) ?? s.Key)], [.. place.Steps.Select(s => s.IsNamed)]) : null;

    /// <summary>The path that leads there. What is called by a name that others in its list have too, or has none any more, is called by its number.</summary>
    /// <param name="root">The scene.</param>
    public string Path(JsonNode root)
    {
        string path = "";
        JsonNode? node = root;
        for (int i = 0; i < Steps.Count; i++)
        {
            bool isElement = int.TryParse(Steps[i], NumberStyles.None, CultureInfo.InvariantCulture, out int index) && node is null or { Kind: JsonKind.Array };
            string? name = isElement && IsNamed[i] && node is not null && index < node.Items.Count ? node.Items[index].Find("name")?.Text : null;
            bool isUnique = name is { Length: > 0 } && node!.Items.Count(n => n.Find("name")?.Text == name) == 1;
            path += isElement && !isUnique ? $"[{Steps[i]}]" : PropertyPath.Word(isElement ? name! : Steps[i], i == 0);
            node = !isElement ? node?.Find(Steps[i]) : node is not null && index < node.Items.Count ? node.Items[index] : null;
        }

        return path;
    }
}
