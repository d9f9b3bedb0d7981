-- | The reference values for rotating holes in @test\/reference@: computed with 34
-- and 50 digits, which agree beyond 1e-20.
module Support.KerrReference
  ( kerrRows,
    KerrRay (..),
    KerrCrossing (..),
    readKerrRays,
    readKerrObservers,
    aimed,
    spinOf,
  )
where

import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Vector.XYZ (XYZ (..))
import Data.Maybe (fromMaybe, mapMaybe)
import Text.Read (readMaybe)

-- | The rows of a table, cell by cell, without comments and heading.
kerrRows :: FilePath -> IO [[String]]
kerrRows name =
  map (splitOn ',') . drop 1 . filter ((/= "#") . take 1) . lines
    <$> readFile ("test/reference/" ++ name)

splitOn :: Char -> String -> [String]
splitOn separator text = case break (== separator) text of
  (cell, _ : rest) -> cell : splitOn separator rest
  (cell, []) -> [cell]

-- | One line of sight with what is known of it.
data KerrRay = KerrRay
  { rayName :: String,
    raySpin :: Spin,
    rayMotion :: Motion,
    rayPlace :: Place,
    rayDirection :: Direction,
    -- | ν_obs/E, λ and Carter's constant.
    rayConstants :: (Double, Double, Double),
    -- | The Mino time to the end, where it is known.
    rayMinoTime :: Maybe Double,
    -- | Where it escapes to, unless it is captured; seen from azimuth φ = 0.
    rayEscape :: Maybe XYZ,
    -- | How much an error of the direction of sight grows.
    raySegment :: Double,
    rayCrossings :: [KerrCrossing],
    -- | The shifts if the gas turned left-handed.
    rayLeftHanded :: [Double]
  }

-- | A crossing of the plane.
data KerrCrossing = KerrCrossing
  { crossingRadius :: Double,
    -- | @atan2 z x@.
    crossingAzimuth :: Double,
    crossingRedshift :: Double
  }

-- | @kerr-rays.csv@.
readKerrRays :: IO [KerrRay]
readKerrRays = mapMaybe ray <$> kerrRows "kerr-rays.csv"
  where
    ray
      ( s : r : i : _ : psi : eta : fate : nu : lambda : q : mino : x : y
          : z
          : segment
          : crossings
          : left
          : _
        ) =
        Just $
          common AtRest (s, r, i, psi, eta) (nu, lambda, q) fate (x, y, z) $ \known ->
            known
              { rayMinoTime = readMaybe mino,
                raySegment = fromMaybe 1 (readMaybe segment),
                rayCrossings =
                  [ KerrCrossing (number radius) (number azimuth) (number g)
                    | crossing <- splitOn ';' crossings,
                      [radius, azimuth, g] <- [splitOn ':' crossing]
                  ],
                rayLeftHanded = mapMaybe readMaybe (splitOn ';' left)
              }
    ray _ = Nothing

-- | @kerr-observers.csv@.
readKerrObservers :: IO [KerrRay]
readKerrObservers = mapMaybe ray <$> kerrRows "kerr-observers.csv"
  where
    ray (name : s : r : i : psi : eta : nu : lambda : q : fate : x : y : z : _) = do
      motion <-
        lookup
          name
          [ ("static", AtRest),
            ("zamo", ZeroAngularMomentum),
            ("orbiting", OnOrbit RightHanded),
            ("falling", InFreeFall)
          ]
      pure (common motion (s, r, i, psi, eta) (nu, lambda, q) fate (x, y, z) id)
    ray _ = Nothing

type Cells3 = (String, String, String)

common ::
  Motion ->
  (String, String, String, String, String) ->
  Cells3 ->
  String ->
  Cells3 ->
  (KerrRay -> KerrRay) ->
  KerrRay
common motion (s, r, i, psi, eta) (nu, lambda, q) fate (x, y, z) finish =
  finish
    KerrRay
      { rayName =
          unwords [show motion, "spin", s, "at r", r, "inclination", i, "psi", psi, "eta", eta],
        raySpin = spinOf (number s),
        rayMotion = motion,
        rayPlace = Place (number r) (degrees (number i)),
        rayDirection = aimed (degrees (number psi)) (degrees (number eta)),
        rayConstants = (number nu, number lambda, number q),
        rayMinoTime = Nothing,
        rayEscape =
          if fate == "escaped" then Just (XYZ (number x) (number y) (number z)) else Nothing,
        raySegment = 1,
        rayCrossings = [],
        rayLeftHanded = []
      }
  where
    degrees v = v * pi / 180

-- | NaN for what is no number, which no comparison accepts.
number :: String -> Double
number = fromMaybe (0 / 0) . readMaybe

-- | The direction at the angle ψ from straight inward and the position angle η from
-- screen-right towards screen-up.
aimed :: Double -> Double -> Direction
aimed psi eta = Direction (negate (cos psi)) (negate (sin psi * sin eta)) (sin psi * cos eta)

-- | A spin known to lie within (−1, 1).
spinOf :: Double -> Spin
spinOf s = fromMaybe (error ("no spin: " ++ show s)) (spin s)
