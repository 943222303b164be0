using System.Collections;
using System.Globalization;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using System.Text;
using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Jobs;

/// <summary>
/// The hash of all that decides what a sample comes to: the description with every value, the content of every file that it names, and the part that
/// is rendered. Where files lie, what they are called and how scenes are written does not count.
/// </summary>
public sealed class ContentHash : IDisposable
{
    private readonly IncrementalHash _hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
    private readonly Dictionary<object, int> _seen = new(ReferenceEqualityComparer.Instance);
    private readonly string _folder;

    private ContentHash(string folder) => _folder = folder;

    /// <summary>Computes it.</summary>
    /// <param name="scene">The scene as it is rendered.</param>
    /// <param name="path">The scene's file; others are looked for from its folder.</param>
    /// <param name="crop">The part that is rendered; null for all.</param>
    public static string Of(SceneDescription scene, string path, Tile? crop)
    {
        using ContentHash hash = new(Path.GetDirectoryName(path) ?? "");
        hash.Text(ProgramName.Text);
        hash.Text($"{crop}");
        hash.Add(scene with { Animation = [], Render = scene.Render with { SamplesPerPixel = scene.Render.Sampler.DependsOnCount ? scene.Render.SamplesPerPixel : 1 } });
        return Convert.ToHexStringLower(hash._hash.GetHashAndReset());
    }

    /// <summary>As <see cref="Of"/>, of a picture with all its samples.</summary>
    /// <param name="scene">The scene as it is rendered.</param>
    /// <param name="path">The scene's file; others are looked for from its folder.</param>
    /// <param name="crop">The part that is rendered; null for all.</param>
    public static string OfPicture(SceneDescription scene, string path, Tile? crop) =>
        string.Create(CultureInfo.InvariantCulture, $"{Of(scene, path, crop)}-{scene.Render.SamplesPerPixel}");

    /// <inheritdoc/>
    public void Dispose() => _hash.Dispose();

    private void Add(object? value)
    {
        switch (value)
        {
            case null:
                Text("-");
                break;
            case string text:
                Text(text);
                break;
            case IFormattable number and not Enum:
                Text(number.ToString(null, CultureInfo.InvariantCulture));
                break;
            case Enum or bool:
                Text($"{value}");
                break;
            case NamedValue { Name: var name }:
                Text(char.ToUpperInvariant(name[0]) + name[1..]);
                break;
            case IDictionary named:
                AddNamed(named);
                break;
            case IEnumerable things:
                AddAll(things);
                break;
            default:
                AddRecord(value);
                break;
        }
    }

    private void AddNamed(IDictionary named)
    {
        Text($"named {named.Count}");
        foreach (DictionaryEntry entry in named)
        {
            Text((string)entry.Key);
            Add(entry.Value);
        }
    }

    private void AddAll(IEnumerable things)
    {
        switch (things)
        {
            case IEnumerable<float> numbers:
                Numbers<float>([.. numbers]);
                break;
            case IEnumerable<int> numbers:
                Numbers<int>([.. numbers]);
                break;
            case IEnumerable<Vector2> vectors:
                Numbers<Vector2>([.. vectors]);
                break;
            case IEnumerable<Vector3> vectors:
                Numbers<Vector3>([.. vectors]);
                break;
            case IEnumerable<TriangleIndices> triangles:
                Numbers<TriangleIndices>([.. triangles]);
                break;
            default:
                object?[] all = [.. things.Cast<object?>()];
                Text($"list {all.Length}");
                Array.ForEach(all, Add);
                break;
        }
    }

    private void AddRecord(object record)
    {
        if (record.GetType().IsValueType)
        {
            // Small values such as colours.
            foreach (System.Reflection.FieldInfo field in record.GetType().GetFields(System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.Public | System.Reflection.BindingFlags.NonPublic))
            {
                Add(field.GetValue(record));
            }

            return;
        }

        if (!_seen.TryAdd(record, _seen.Count))
        {
            Text($"again {_seen[record]}");
            return;
        }

        RecordType type = RecordType.Of(record.GetType());
        Text(type.Origin is { } origin ? $"record {type.Name} of {origin}" : $"record {type.Name}");
        foreach (RecordParameter parameter in type.Parameters)
        {
            Text(parameter.Key);
            object? value = parameter.Get(record);
            if (parameter.Kind == ParameterKind.File && value is string { Length: > 0 } file)
            {
                AddFile(Path.GetFullPath(Path.Combine(_folder, file)));
            }
            else
            {
                Add(value);
            }
        }
    }

    private void AddFile(string path)
    {
        string folder = Path.GetDirectoryName(path)!;
        foreach (string file in ModelSidecars.Everywhere(path).Select(n => Path.Combine(folder, n)).Prepend(path).Where(File.Exists))
        {
            using FileStream stream = File.OpenRead(file);
            Text(Convert.ToHexStringLower(SHA256.HashData(stream)));
        }
    }

    private void Numbers<T>(T[] values)
        where T : unmanaged
    {
        Text($"numbers {values.Length}");
        _hash.AppendData(MemoryMarshal.AsBytes(values.AsSpan()));
    }

    // With its length before it, so that no two sequences of texts are the same bytes.
    private void Text(string text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text);
        _hash.AppendData(BitConverter.GetBytes(bytes.Length));
        _hash.AppendData(bytes);
    }
}
