-- | The sky behind a few pixels of a row at once.
--
-- Between two beams that differ little, the beams between them follow by interpolation.
-- Where moreover no star stands between them and the diffuse light is even, so does the
-- light.
module BlackHole.Trace.SkySpan
  ( SkyNode,
    skyNode,
    spanLength,
    spanStart,
    spanMiddle,
    SkySpan,
    skySpan,
    skyInSpan,
  )
where

import BlackHole.Light.Radiance
import BlackHole.Scene.Camera (pixelMiddle)
import BlackHole.Trace.RayDifferential
import BlackHole.Trace.Sky
import BlackHole.Trace.SkyLight
import BlackHole.Trace.Tracer
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ ((*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ

-- | The sky behind a pixel from which the sky behind its neighbours in the row follows:
-- the beam, the observed frequency over the sky's, and the light.
data SkyNode = SkyNode {-# UNPACK #-} !RayDifferential {-# UNPACK #-} !Double Radiance

-- | The sky behind the pixel in a column and a row, if any light arrives from it and it is
-- known for whole pixels.
skyNode :: Tracer -> Int -> Int -> Maybe SkyNode
skyNode traced column row = case tracerSky traced of
  ByDifferential _ shader -> node <$> skyBeam traced (pixelMiddle column row)
    where
      node (differential, shift) = SkyNode differential shift (shader shift differential)
  ByDirection _ -> Nothing

-- | How many pixels of a row a span has.
spanLength :: Int
spanLength = 8

-- | The first column of the span that holds a column.
spanStart :: Int -> Int
spanStart column = column - column `rem` spanLength

-- | The middle of the span that begins in a column of a row.
spanMiddle :: Int -> Int -> XY
spanMiddle column row =
  XY (fromIntegral column + 0.5 * fromIntegral spanLength) (fromIntegral row + 0.5)

-- | The sky behind the pixels of a row from one multiple of 'spanLength' to the next.
data SkySpan
  = -- | Its light changes evenly from the first pixel to the first of the next span.
    EvenLight !Radiance !Radiance
  | -- | The beams do, and this shader finds their light.
    EvenBeams !(Double -> RayDifferential -> Radiance) !SkyNode !SkyNode
  | -- | It has to be found for each pixel.
    Uneven

-- | The span between two nodes.
skySpan :: Tracer -> Maybe SkyNode -> Maybe SkyNode -> SkySpan
skySpan traced (Just node@(SkyNode first _ light)) (Just node'@(SkyNode final _ light'))
  | ByDifferential between _ <- tracerSky traced,
    straight = case between first final of
    Linear -> EvenLight light light'
    Shaded shader -> EvenBeams shader node node'
  where
    RayDifferential d a b = first
    RayDifferential d' a' b' = final
    -- The beams change little.
    straight = small (a' ^-^ a) && small (b' ^-^ b) && small (mean ^-^ a)
    mean = (1 / fromIntegral spanLength) *^ (d' ^-^ d)
    small change = XYZ.dot change change < 0.04 * min (XYZ.dot a a) (XYZ.dot b b)
skySpan _ _ _ = Uneven

-- | The light of the sky behind a pixel, given the span that holds it.
skyInSpan :: Tracer -> SkySpan -> Int -> Int -> Radiance
skyInSpan traced within column row = case within of
  EvenLight first final -> scaleRadiance (1 - t) first <+> scaleRadiance t final
  EvenBeams shader (SkyNode first shift _) (SkyNode final shift' _) ->
    shader (shift + t * (shift' - shift)) (beamBetween first final t)
  Uneven -> patchLight (pixelSky traced column row)
  where
    t = fromIntegral (column `rem` spanLength) / fromIntegral spanLength

-- | The beam at a fraction of the way along a span, by Hermite's interpolation of the
-- direction.
beamBetween :: RayDifferential -> RayDifferential -> Double -> RayDifferential
beamBetween (RayDifferential d a b) (RayDifferential d' a' b') t =
  RayDifferential direction (alongX a a') (alongX b b')
  where
    n = fromIntegral spanLength
    s = 1 - t
    along =
      ((1 + 2 * t) * s * s) *^ d
        ^+^ (t * s * s * n) *^ a
        ^+^ (t * t * (3 - 2 * t)) *^ d'
        ^-^ (t * t * s * n) *^ a'
    direction = (1 / XYZ.norm along) *^ along
    alongX p p' = s *^ p ^+^ t *^ p'
