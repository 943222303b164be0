using System.Security.Cryptography;
using System.Text;

namespace RayTracer.Studio;

/// <summary>
/// Lets nothing through but our own page talking to our own port. Other pages in the user's browser, other users of the machine
/// and names that suddenly mean this machine (DNS rebinding) are refused.
/// </summary>
/// <param name="token">The secret that each request for data must bear.</param>
internal sealed class LocalGuard(string token)
{
    /// <summary>The header that bears the secret.</summary>
    public const string TokenHeader = "X-Studio-Token";

    /// <summary>The path of the data. All else are the pages, which are no secret.</summary>
    public const string Api = "/api";

    /// <summary>
    /// The one request whose secret is in its body, because a page that is going away cannot set a header: its handler looks.
    /// </summary>
    public const string Farewell = Api + "/bye";

    private readonly byte[] _token = Digest(token);
    private string _host = "";

    /// <summary>Raised when a request with the secret has come.</summary>
    public event EventHandler? Admitted;

    /// <summary>The number of the secret's characters.</summary>
    public int TokenLength => token.Length;

    /// <summary>Sets the port, once it is known; before, everything is refused.</summary>
    public void Listen(int port) => _host = $"127.0.0.1:{port}";

    /// <summary>Returns whether a text is the secret. Takes the same time for all texts of a length.</summary>
    public bool IsToken(string? given) => CryptographicOperations.FixedTimeEquals(Digest(given ?? ""), _token);

    /// <summary>Checks a request, and passes it on or refuses it.</summary>
    public Task Invoke(HttpContext context, RequestDelegate next)
    {
        HttpRequest request = context.Request;
        bool isApi = request.Path.StartsWithSegments(Api, StringComparison.OrdinalIgnoreCase);
        SetHeaders(context.Response.Headers, isApi);
        if (request.Headers.Host is not [var host] || host != _host)
        {
            return Refuse(context, StatusCodes.Status421MisdirectedRequest, "This is not the host that was asked for.");
        }

        if (request.Headers.Origin is not ([] or [_]) || (request.Headers.Origin is [var origin] && origin != $"http://{_host}"))
        {
            return Refuse(context, StatusCodes.Status403Forbidden, "Requests of other origins are refused.");
        }

        if (!IsOwn(request, isApi))
        {
            return Refuse(context, StatusCodes.Status403Forbidden, "Requests of other sites are refused.");
        }

        if (isApi && request.Path != Farewell)
        {
            if (request.Headers[TokenHeader] is not [var given] || !IsToken(given))
            {
                return Refuse(context, StatusCodes.Status401Unauthorized, $"The secret in the header {TokenHeader} is missing or wrong.");
            }

            Admitted?.Invoke(this, EventArgs.Empty);
        }

        return next(context);
    }

    // What the browser says about who asks. The page itself may be gone to from elsewhere: from the file with which it is opened.
    private static bool IsOwn(HttpRequest request, bool isApi) => request.Headers["Sec-Fetch-Site"] switch
    {
        [] or ["same-origin" or "none"] => true,
        _ => !isApi && request.Headers["Sec-Fetch-Mode"] is ["navigate"] && request.Headers["Sec-Fetch-Dest"] is ["document"],
    };

    private static void SetHeaders(IHeaderDictionary headers, bool isApi)
    {
        headers.XContentTypeOptions = "nosniff";
        headers["Referrer-Policy"] = "no-referrer";
        headers["Cross-Origin-Resource-Policy"] = "same-origin";
        headers["Cross-Origin-Opener-Policy"] = "same-origin";
        headers.ContentSecurityPolicy = ContentPolicy.Header;
        if (isApi)
        {
            headers.CacheControl = "no-store";
        }
    }

    private static byte[] Digest(string text) => SHA256.HashData(Encoding.UTF8.GetBytes(text));

    private static Task Refuse(HttpContext context, int status, string reason)
    {
        context.Response.StatusCode = status;
        return context.Response.WriteAsJsonAsync(new ErrorAnswer(reason), ApiJson.Options, context.RequestAborted);
    }
}

/// <summary>The Content Security Policy of the page: it may load nothing but what comes from this server.</summary>
internal static class ContentPolicy
{
    /// <summary>The header's value. Style sheets that the page makes itself are constructed ones, which need no permission.</summary>
    public const string Header = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; font-src 'self'; "
        + "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
}
