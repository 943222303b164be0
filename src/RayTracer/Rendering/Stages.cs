using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Follows paths in stages: new ones start, all rays meet the scene, hits are sorted by what is shaded together, and every group is shaded,
/// which sends the paths on. The report's recursion (listing 6.3) is this loop turned inside out.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="streamSize">The number of paths that are followed together.</param>
/// <param name="shader">Shades.</param>
/// <param name="clock">Measures the stages; null where nobody looks.</param>
internal sealed unsafe class Stages(Scene scene, int streamSize, SurfaceShader shader, StageClock? clock = null)
{
    private readonly GroupMembers _members = new(scene, streamSize);
    private readonly PinnedBuffer<int> _hits = new(scene.World.RoomForHits(streamSize));
    private PathStream _current = PathStream.Take(streamSize);
    private PathStream _next = PathStream.Take(streamSize);
    private PathStream? _rays;

    /// <summary>Number of rays whose nearest hit was looked for.</summary>
    public long Rays { get; private set; }

    /// <summary>Gives the memory of the streams back; no paths are followed any more.</summary>
    public void Close()
    {
        _current.GiveBack();
        _next.GiveBack();
    }

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
            if (source.Rays is null)
            {
                clock?.Enter(Stage.Generate);
                source.Fill(_current, _current.Capacity);
            }
            else
            {
                FollowRays(source, afterStep);
            }

            if (_current.Count == 0)
            {
                break;
            }

            _next.Count = 0;
            Step(_current, _next);
            clock?.Enter(Stage.Film);
            afterStep?.Invoke(_next);
            (_current, _next) = (_next, _current);
        }

        shader.End();
        clock?.Enter(Stage.Rest);
    }

    // The samples that share camera rays part where those meet the scene, and join the other paths. Few rays would make sparse packets.
    private void FollowRays(PathSource source, Action<PathStream>? afterStep)
    {
        int ways = scene.Splitting!.Ways;
        int most = Math.Max(_current.Capacity / ways, 1);
        int room = (_current.Capacity - _current.Count) / ways;
        while (room >= most / 2 || _current.Count == 0)
        {
            _rays ??= new(most);
            _rays.Count = 0;
            clock?.Enter(Stage.Generate);
            source.Fill(_rays, room);
            if (_rays.Count == 0)
            {
                return;
            }

            shader.Splits = true;
            Step(_rays, _current);
            shader.Splits = false;
            clock?.Enter(Stage.Film);
            afterStep?.Invoke(_current);
            room = (_current.Capacity - _current.Count) / ways;
        }
    }

    // All rays of a stream meet the scene and are shaded; paths that go on are added to another.
    private void Step(PathStream stream, PathStream next)
    {
        clock?.Enter(Stage.Intersect);
        scene.World.ClosestHit(stream, _hits.Pointer);
        Rays += stream.Count;
        clock?.Enter(Stage.Shade);
        shader.SampleMedia(stream);
        clock?.Enter(Stage.Sort);
        _members.Sort(stream);
        clock?.Enter(Stage.Shade);
        for (int group = 0; group < _members.Count; group++)
        {
            uint* members = _members.Of(group, out int count);
            if (count == 0)
            {
                continue;
            }

            if (group == scene.Groups.Length)
            {
                shader.Miss(stream, members, count);
            }
            else if (group > scene.Groups.Length)
            {
                shader.Scatter(stream, next, members, count);
            }
            else
            {
                shader.Shade(scene.Groups[group], stream, next, members, count);
            }
        }

        clock?.Enter(Stage.Shadow);
        shader.Flush(next);
    }
}
