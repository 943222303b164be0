using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Follows paths in stages: new ones start, all rays meet the scene, hits are sorted by what is shaded together, and every group is shaded,
/// which sends the paths on. The report's recursion (listing 6.3) is this loop turned inside out.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="streamSize">The number of paths that are followed together.</param>
/// <param name="shader">Shades.</param>
internal sealed unsafe class Stages(Scene scene, int streamSize, SurfaceShader shader)
{
    private readonly GroupMembers _members = new(scene, streamSize);
    private readonly PinnedBuffer<int> _hits = new(scene.World.RoomForHits(streamSize));
    private PathStream _current = new(streamSize);
    private PathStream _next = new(streamSize);

    /// <summary>Number of rays whose nearest hit was looked for.</summary>
    public long Rays { get; private set; }

    /// <summary>Follows the paths of a source to their ends.</summary>
    /// <param name="source">Starts them.</param>
    /// <param name="samples">Their samples.</param>
    /// <param name="afterStep">Called with the paths that go on; null where nobody asks.</param>
    public void Follow(PathSource source, SampleRange samples, Action<PathStream>? afterStep = null)
    {
        shader.Begin(source, samples);
        _current.Count = 0;
        while (true)
        {
            source.Fill(_current);
            if (_current.Count == 0)
            {
                break;
            }

            scene.World.ClosestHit(_current, _hits.Pointer);
            Rays += _current.Count;
            shader.SampleMedia(_current);
            _members.Sort(_current);
            Shade();
            afterStep?.Invoke(_next);
            (_current, _next) = (_next, _current);
        }

        shader.End();
    }

    private void Shade()
    {
        _next.Count = 0;
        for (int group = 0; group < _members.Count; group++)
        {
            uint* members = _members.Of(group, out int count);
            if (count == 0)
            {
                continue;
            }

            if (group == scene.Groups.Length)
            {
                shader.Miss(_current, members, count);
            }
            else if (group > scene.Groups.Length)
            {
                shader.Scatter(_current, _next, members, count);
            }
            else
            {
                shader.Shade(scene.Groups[group], _current, _next, members, count);
            }
        }

        shader.Flush(_next);
    }
}
