using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>
/// Further numbers of vertices or faces, one or three of a name, by the names that Mitsuba gives them: of <c>heat_0</c>, <c>heat_1</c>,
/// <c>heat_2</c> of faces, <c>face_heat</c>; of <c>heat_r</c> …, <c>face_heat_color</c>; of <c>r</c> or <c>red</c> …, <c>face_color</c>.
/// </summary>
internal sealed class PlyAttributes
{
    private readonly Dictionary<int, int> _places = [];
    private readonly List<MeshAttribute> _all = [];
    private readonly List<int> _channels = [];
    private readonly List<List<Rgb>> _values = [];
    private readonly float[] _now;

    /// <summary>Finds the attributes of things of a kind.</summary>
    /// <param name="kind">The kind: vertex or face.</param>
    /// <param name="element">The things.</param>
    /// <param name="isTaken">True for properties that have another meaning.</param>
    public PlyAttributes(string kind, PlyElement element, Predicate<PlyProperty> isTaken)
    {
        var named = element.Properties.Select((Property, Index) => (Property, Index)).Where(p => p.Property.CountType is null && !isTaken(p.Property))
            .Select(p => (Name: NameOf(p.Property.Name), p.Index)).Where(p => p.Name is not null).GroupBy(p => p.Name!).Where(g => g.Count() is 1 or 3);
        foreach (var group in named)
        {
            int channel = 0;
            foreach ((_, int index) in group)
            {
                _places.Add(index, (3 * _channels.Count) + channel++);
            }

            _channels.Add(channel);
            _values.Add([]);
            _all.Add(new($"{kind}_{group.Key}", []));
        }

        _now = new float[3 * _channels.Count];
    }

    /// <summary>The attributes, with a colour for each thing that was added.</summary>
    public IEnumerable<MeshAttribute> All => _all.Select((a, i) => a with { Values = [.. _values[i]] });

    /// <summary>Reads a number of a thing, or skips it.</summary>
    public void Read(ref PlyValues values, PlyElement element, int property)
    {
        if (_places.TryGetValue(property, out int place))
        {
            _now[place] = (float)values.Number(element.Properties[property].Type);
        }
        else
        {
            values.Skip(element.Properties[property]);
        }
    }

    /// <summary>Adds what was read last, a number of times.</summary>
    public void Add(int times)
    {
        for (int i = 0; i < _channels.Count; i++)
        {
            Rgb color = _channels[i] == 1 ? new(_now[3 * i], _now[3 * i], _now[3 * i]) : new(_now[3 * i], _now[(3 * i) + 1], _now[(3 * i) + 2]);
            for (int time = 0; time < times; time++)
            {
                _values[i].Add(color);
            }
        }
    }

    private static string? NameOf(string property)
    {
        if (property is "r" or "g" or "b" or "red" or "green" or "blue")
        {
            return "color";
        }

        int end = property.LastIndexOf('_');
        return end <= 0 || end != property.Length - 2 ? null : property[^1] switch
        {
            'r' or 'g' or 'b' => $"{property[..end]}_color",
            (>= '0' and <= '9') or (>= 'x' and <= 'z') => property[..end],
            _ => null,
        };
    }
}
