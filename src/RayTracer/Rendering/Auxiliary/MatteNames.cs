using System.Numerics;
using System.Text;
using RayTracer.Acceleration;
using RayTracer.Materials;

namespace RayTracer.Rendering;

/// <summary>
/// The names of what a scene shows, and the numbers that Cryptomattes have for them. A thing is called by its own name, or else that of the closest group, object or model
/// around it; what an instance shows, by the instance's first. What has no name is called by its type and a number.
/// </summary>
internal sealed class MatteNames
{
    private readonly World _world;
    private readonly Dictionary<Space, uint[]> _surfaces = new(ReferenceEqualityComparer.Instance);
    private readonly uint[] _instances;
    private readonly uint[] _materials;
    private readonly int[] _groupOfPrimitive;
    private readonly Dictionary<string, int> _unnamed = new(StringComparer.Ordinal);
    private readonly Dictionary<uint, string> _names = [];

    /// <summary>Finds all names of a scene.</summary>
    public MatteNames(Scene scene)
    {
        (_world, _groupOfPrimitive) = (scene.World, scene.GroupOfPrimitive);
        foreach (Space space in _world.Spaces)
        {
            IEnumerable<string> shapes = space.Shapes.Select(s => Named(s.Label?.Name ?? space.Contents.Name, s.GetType().Name));
            IEnumerable<string> meshes = space.Contents.Meshes.Select(m => Named(m.Label?.Name ?? space.Contents.Name, "mesh"));
            _surfaces.Add(space, [.. shapes.Concat(meshes).Select(Known)]);
        }

        _instances = [.. Enumerable.Range(1, _world.Instances?.Count ?? 0).Select(i => _world.Instances!.LabelOf(i)?.Name is { } name ? Known(name) : 0)];
        Dictionary<Material, uint> materials = new(ReferenceEqualityComparer.Instance);
        foreach (Material material in scene.Groups.Select(g => g.Material))
        {
            if (!materials.ContainsKey(material))
            {
                string type = material.GetType().Name;
                materials.Add(material, Known(Named(material.Name, type.EndsWith(nameof(Material), StringComparison.Ordinal) ? type[..^nameof(Material).Length] : type)));
            }
        }

        _materials = [.. scene.Groups.Select(g => materials[g.Material])];
    }

    /// <summary>The number of what a ray meets.</summary>
    /// <param name="kind">What is distinguished.</param>
    /// <param name="primitive">The primitive.</param>
    /// <param name="instance">The instance that shows it; 0 for the world itself.</param>
    public uint Of(CryptomatteKind kind, int primitive, int instance)
    {
        if (kind == CryptomatteKind.Material)
        {
            return _materials[_groupOfPrimitive[primitive]];
        }

        if (instance > 0 && _instances[instance - 1] is not 0 and var named)
        {
            return named;
        }

        Space space = instance > 0 ? _world.Instances!.SpaceOf(instance) : _world.Itself;
        return _surfaces[space][space.SurfaceOf(primitive)];
    }

    /// <summary>The name behind a number.</summary>
    public string NameOf(uint id) => _names[id];

    /// <summary>
    /// The number of a name: its hash as the bits of a float that is neither infinite nor denormal (the specification's "uint32_to_float32").
    /// </summary>
    public static uint IdOf(string name)
    {
        uint hash = MurmurHash(Encoding.UTF8.GetBytes(name));
        uint exponent = (hash >> 23) & 255;
        return exponent is 0 or 255 ? hash ^ (1u << 23) : hash;
    }

    /// <summary>A. Appleby's MurmurHash3 (2011), of 32 bits, with the seed 0.</summary>
    public static uint MurmurHash(ReadOnlySpan<byte> text)
    {
        uint hash = 0;
        for (int i = 0; i < text.Length; i += 4)
        {
            uint block = 0;
            for (int j = int.Min(4, text.Length - i) - 1; j >= 0; j--)
            {
                block = (block << 8) | text[i + j];
            }

            hash ^= BitOperations.RotateLeft(block * 0xCC9E2D51, 15) * 0x1B873593;
            hash = i + 4 <= text.Length ? (BitOperations.RotateLeft(hash, 13) * 5) + 0xE6546B64 : hash;
        }

        hash ^= (uint)text.Length;
        hash = (hash ^ (hash >> 16)) * 0x85EBCA6B;
        hash = (hash ^ (hash >> 13)) * 0xC2B2AE35;
        return hash ^ (hash >> 16);
    }

    private string Named(string? name, string type)
    {
        if (name is { Length: > 0 })
        {
            return name;
        }

        int number = _unnamed[type] = _unnamed.GetValueOrDefault(type) + 1;
        return $"{char.ToLowerInvariant(type[0])}{type[1..]} {number}";
    }

    private uint Known(string name)
    {
        uint id = IdOf(name);
        _names.TryAdd(id, name);
        return id;
    }
}
