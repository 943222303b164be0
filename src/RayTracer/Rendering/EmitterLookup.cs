using System.Numerics;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Rendering;

/// <summary>Finds the light that a ray has met by chance, and with what density its direction would have been sampled.</summary>
internal sealed unsafe class EmitterLookup
{
    private const uint Nothing = uint.MaxValue;
    private readonly LightSelection? _selection;
    private readonly LightSource[] _lights;
    private readonly Dictionary<ShadingGroup, int> _groups;
    private readonly Dictionary<(uint Instance, int Key), int> _numbers = [];

    public EmitterLookup(Scene scene)
    {
        _lights = [.. scene.SampledLights];
        for (int i = 0; i < _lights.Length; i++)
        {
            LightSource light = _lights[i];
            if (light is MeshLight mesh)
            {
                // All triangles of a material: what is shaded together.
                int group = Array.FindIndex(scene.Groups, g => g.Batch == mesh.Mesh && g.Material == mesh.Luminaire);
                _numbers.Add(((uint)light.Instance, ~group), i);
            }
            else if (light.Primitive >= 0)
            {
                _numbers.Add(((uint)light.Instance, light.Primitive), i);
            }
        }

        _selection = scene.LightSelection;
        _groups = scene.Groups.Select((group, i) => (group, i)).ToDictionary(g => g.group, g => g.i);
    }

    /// <summary>Number of lights.</summary>
    public int Count => _lights.Length;

    /// <summary>The density, per steradian, with which the lights that were met are sampled in those directions.</summary>
    /// <param name="group">The group of hits.</param>
    /// <param name="instance">The instances that show it.</param>
    /// <param name="hit">The points at which rays meet it.</param>
    /// <param name="lanes">The lanes asked for.</param>
    /// <param name="pdf">The densities; zero where nothing is sampled.</param>
    public void Pdf(ShadingGroup group, in UIntW instance, in LightHitW hit, in MaskW lanes, out FloatW pdf) =>
        Densities(group, instance, hit, lanes, null, out pdf, out _);

    /// <summary>
    /// As <see cref="Pdf"/>, and the density with which paths of light start in the opposite direction.
    /// </summary>
    /// <param name="group">The group of hits.</param>
    /// <param name="instance">The instances that show it.</param>
    /// <param name="hit">The points at which rays meet it.</param>
    /// <param name="lanes">The lanes asked for.</param>
    /// <param name="emission">Starts those paths; null where nobody asks.</param>
    /// <param name="pdf">The densities; zero where nothing is sampled.</param>
    /// <param name="emitted">Their density, of light, point and direction; zero where none starts.</param>
    public void Densities(ShadingGroup group, in UIntW instance, in LightHitW hit, in MaskW lanes, LightEmission? emission, out FloatW pdf, out FloatW emitted)
    {
        (pdf, emitted) = (0f, 0f);
        uint rest = lanes.Bits;
        uint* numbers = stackalloc uint[16];
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            numbers[lane] = (rest >> lane & 1) != 0 ? (uint)Find(group, instance[lane], hit.Primitive[lane]) : Nothing;
        }

        // Lights one after the other; most often there is one only.
        UIntW met = UIntW.Load(numbers);
        for (; rest != 0; rest &= rest - 1)
        {
            uint light = numbers[BitOperations.TrailingZeroCount(rest)];
            if (light != Nothing)
            {
                MaskW same = UIntW.Equal(met, light);
                _lights[light].Pdf(hit, out FloatW one);
                if (_selection is not null)
                {
                    _selection.Probability(hit.From, hit.FromNormal, light, out FloatW probability);
                    one *= probability;
                }

                pdf = same.Select(one, pdf);
                if (emission is not null)
                {
                    _lights[light].EmissionPdf(hit, out FloatW point, out FloatW direction);
                    emitted = same.Select(point * direction * emission.Probability(light), emitted);
                }

                rest &= ~same.Bits | (rest & (uint)-(int)rest);
            }
        }
    }

    /// <summary>The number of the light that a ray has met; −1 where it is not sampled.</summary>
    /// <param name="group">The group of hits.</param>
    /// <param name="instance">The instance that shows it.</param>
    /// <param name="primitive">The primitive.</param>
    public int Find(ShadingGroup group, uint instance, uint primitive) =>
        _numbers.TryGetValue((instance, group.Batch is Acceleration.ShapeBatch ? (int)primitive : ~_groups[group]), out int light) ? light : -1;
}
