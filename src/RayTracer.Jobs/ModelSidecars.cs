using System.Buffers.Binary;
using System.Text;
using RayTracer.Scenes;

namespace RayTracer.Jobs;

/// <summary>The files that a model file names: materials, buffers, pictures.</summary>
public static class ModelSidecars
{
    private const int LongestText = 1 << 28;

    /// <summary>Their paths, relative to the model's folder; only those that are within it.</summary>
    /// <param name="path">The model file.</param>
    public static IReadOnlyList<string> Of(string path)
    {
        string folder = Path.GetDirectoryName(path)!;
        return [.. Everywhere(path).Where(n => IsWithin(folder, n))];
    }

    /// <summary>Their paths, relative to the model's folder or absolute, wherever they are.</summary>
    /// <param name="path">The model file.</param>
    public static IReadOnlyList<string> Everywhere(string path)
    {
        string folder = Path.GetDirectoryName(path)!;
        IEnumerable<string> names = Path.GetExtension(path).ToLowerInvariant() switch
        {
            ".obj" => OfObj(path, folder),
            ".gltf" => Uris(Text(path)),
            ".glb" => Uris(GlbText(path)),
            _ => [],
        };
        return [.. names.Select(n => n.Replace('\\', '/')).Where(n => IsThere(folder, n)).Distinct(StringComparer.Ordinal)];
    }

    private static bool IsThere(string folder, string name) =>
        name.Length > 0 && !name.Contains('\0', StringComparison.Ordinal) && File.Exists(Path.Combine(folder, name));

    private static bool IsWithin(string folder, string name) =>
        name.Length > 0 && !name.Contains('\0', StringComparison.Ordinal) && !Path.IsPathRooted(name)
        && Path.GetFullPath(Path.Combine(folder, name))
            .StartsWith(Path.GetFullPath(folder) + Path.DirectorySeparatorChar, StringComparison.Ordinal);

    private static IEnumerable<string> OfObj(string path, string folder)
    {
        // A statement may name several libraries, or one whose name has spaces.
        foreach (string library in Statements(path, k => k == "mtllib").SelectMany(s => s.Split((char[])[' ', '\t']).Prepend(s)))
        {
            yield return library;
            string name = library.Replace('\\', '/');
            if (!IsThere(folder, name))
            {
                continue;
            }

            foreach (string map in Statements(Path.Combine(folder, name), k => k.StartsWith("map_", StringComparison.Ordinal) || k is "bump" or "disp" or "decal" or "refl" or "norm"))
            {
                // Options may stand before the name, and the name may have spaces. Readers also look for what another machine's path ends
                // on.
                yield return map;
                yield return map[(map.LastIndexOf(' ') + 1)..];
                yield return map[(map.LastIndexOfAny(['/', '\\']) + 1)..];
            }
        }
    }

    private static IEnumerable<string> Statements(string path, Func<string, bool> isWanted) => File.ReadLines(path)
        .Select(l => l.Trim().Split((char[])[' ', '\t'], 2))
        .Where(s => s.Length == 2 && isWanted(s[0].ToLowerInvariant()))
        .Select(s => s[1].Trim());

    private static IEnumerable<string> Uris(string json) => JsonParser.Parse(new SourceText("", json), new List<Diagnostic>()) is { } root
        ? All(root).Where(u => !u.StartsWith("data:", StringComparison.OrdinalIgnoreCase)).Select(Uri.UnescapeDataString) : [];

    private static IEnumerable<string> All(JsonNode node) => node.Items.SelectMany(All)
        .Concat(node.Members.SelectMany(m => m.Key == "uri" && m.Value.Kind == JsonKind.String ? [m.Value.Text] : All(m.Value)));

    private static string Text(string path) => new FileInfo(path).Length > LongestText ? "" : File.ReadAllText(path);

    // glTF 2.0 specification, section 4.4: a header of 12 bytes, then the length and the kind of the first chunk, which is the text.
    private static string GlbText(string path)
    {
        using FileStream file = File.OpenRead(path);
        byte[] head = new byte[20];
        if (file.ReadAtLeast(head, head.Length, throwOnEndOfStream: false) < head.Length)
        {
            return "";
        }

        uint length = BinaryPrimitives.ReadUInt32LittleEndian(head.AsSpan(12));
        if (length > Math.Min(LongestText, file.Length))
        {
            return "";
        }

        byte[] text = new byte[length];
        int read = file.ReadAtLeast(text, text.Length, throwOnEndOfStream: false);
        return Encoding.UTF8.GetString(text, 0, read);
    }
}
